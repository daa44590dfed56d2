#include "aisle/merging/building_refinement.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "aisle/core/square.hpp"
#include "aisle/merging/map_alignment.hpp"
#include "aisle/merging/moved_building.hpp"
#include "floor_change.hpp"
#include "wall_fates.hpp"
#include "wall_joining.hpp"

namespace aisle {
namespace {

constexpr double kTurnedSpan_m = 1;  // on less of it, a wall's direction does not show
constexpr double kTurnMax_rad = 2 * kDegree;
constexpr double kAddedMin_m = 0.5;  // shorter pieces are not added, as maps of one trip have none either

/// How a trip's faces lie to a wall that it saw again, step by step.
class LineResiduals {
 public:
  /// @param T_map_trip  how the trip as a whole lies in the building
  LineResiduals(const Wall& wall, const MapPattern& trip, const Pose2& T_map_trip) {
    const double length_m = wall.segment.length();
    const Vec2 normal = left_normal((wall.segment.end - wall.segment.start).normalized());
    const std::size_t steps = fate_steps(wall);
    for (std::size_t i = 0; i < steps; ++i) {
      const Vec2 p = middle_of_step(wall.segment, i, steps);
      const Surface* const face = trip.same_wall(p, normal);
      if (face == nullptr) continue;
      at_m_.push_back(length_m * ((static_cast<double>(i) + 0.5) / static_cast<double>(steps) - 0.5));
      off_m_.push_back(face->normal.dot(face->segment.start - p) / face->normal.dot(normal) +
                       normal.dot(T_map_trip * p - p));
    }
    seen_share_ = static_cast<double>(off_m_.size()) / static_cast<double>(steps);
  }

  double seen_share() const { return seen_share_; }
  /// Offset in the wall's middle and change of heading that fit best.
  /// @param may_turn  else the heading stays
  std::pair<double, double> fit(bool may_turn) const {
    const double count = static_cast<double>(off_m_.size());
    double at = 0, off = 0, at_at = 0, at_off = 0;
    for (std::size_t i = 0; i < off_m_.size(); ++i) {
      at += at_m_[i] / count;
      off += off_m_[i] / count;
    }
    for (std::size_t i = 0; i < off_m_.size(); ++i) {
      at_at += square(at_m_[i] - at);
      at_off += (at_m_[i] - at) * (off_m_[i] - off);
    }
    const bool turns = may_turn && at_m_.back() - at_m_.front() > kTurnedSpan_m;
    const double turn = turns ? std::clamp(at_off / at_at, -kTurnMax_rad, kTurnMax_rad) : 0;
    return {off - turn * at, turn};
  }

 private:
  double seen_share_ = 0;
  std::vector<double> at_m_;   ///< along the wall, from its middle
  std::vector<double> off_m_;  ///< across it, towards its free side
};

/// Floor as the trip saw it; what it did not see, and what both draw a little apart, stays.
FloorGrid refined_floor(const FloorGrid& old, const FloorGrid& trip) {
  FloorGrid refined = old;
  const FloorBox& seen = trip.known();
  for (int y = seen.low.y; y < seen.end.y; ++y) {
    for (int x = seen.low.x; x < seen.end.x; ++x) {
      const FloorCell cell{x, y};
      const FloorChange change = change_of_cell(old, trip, cell);
      const bool is_known_surface =
          change == FloorChange::kOnlyNew && trip.at(cell) == Floor::kOccupied && has_surface_at(old, cell);
      const bool has_changed = change == FloorChange::kWon || change == FloorChange::kLost;
      if (has_changed || (change == FloorChange::kOnlyNew && !is_known_surface))
        refined.set(cell, trip.at(cell));
    }
  }
  return refined;
}

Building in_cells_of(const Building& trip, double cell_m) {
  Building same = trip;
  if (same.floor->cell_m() != cell_m) same.floor = moved_floor(*trip.floor, {}, cell_m);
  return same;
}

class Refinement {
 public:
  Refinement(const Building& old, const Building& trip, const RefinementParams& params)
      : params_(params), before_(old), now_(trip), T_map_trip_(settle_map(before_, now_, {}).T_fixed_moved) {}

  void see_again(Wall wall) {
    if (!(wall.segment.length() > 0)) return;
    const std::vector<WallChange> fates = fates_along(wall, now_, WallChange::kGone, params_.denied_m);
    correct(wall);
    std::vector<int> evidence;
    evidence.reserve(fates.size());
    for (const WallChange fate : fates) evidence.push_back(evidence_after(wall.evidence, fate));
    for_each_run(evidence, [&](std::size_t first, std::size_t end) {
      keep(piece_of(wall, first, end, evidence.size()), wall.evidence, evidence[first]);
    });
  }

  /// Adds what the building does not have of a trip's wall.
  void add_new(const Wall& wall) {
    if (wall.segment.length() < kAddedMin_m) return;
    const Vec2 normal = left_normal((wall.segment.end - wall.segment.start).normalized());
    const std::size_t steps = fate_steps(wall);
    std::vector<WallChange> fates;
    for (std::size_t i = 0; i < steps; ++i) {
      const bool is_known = before_.same_wall(middle_of_step(wall.segment, i, steps), normal) != nullptr;
      fates.push_back(is_known ? WallChange::kKept : WallChange::kNew);
    }
    smooth_fates(fates);
    for_each_run(fates, [&](std::size_t first, std::size_t end) {
      const Wall piece = piece_of(wall, first, end, steps);
      if (fates[first] == WallChange::kNew && piece.segment.length() >= kAddedMin_m) keep(piece, 0, 1);
    });
  }

  void finish(RefinedBuilding& refined) && {
    refined.overlap = overlap_of(before_, now_, T_map_trip_);
    refined.building.walls.walls = joined_walls(std::move(walls_));
    refined.walls = std::move(changed_);
    refined.moved_rms_m = corrected_m_ > 0 ? std::sqrt(squares_ / corrected_m_) : 0;
  }

 private:
  static int evidence_after(int evidence, WallChange fate) {
    if (fate == WallChange::kKept) return std::min(evidence + 1, kSureEvidence);
    return fate == WallChange::kGone ? evidence - 1 : evidence;
  }

  template <class Value, class Take>
  static void for_each_run(const std::vector<Value>& values, Take take) {
    for (std::size_t first = 0; first < values.size();) {
      std::size_t end = first;
      while (end < values.size() && values[end] == values[first]) ++end;
      take(first, end);
      first = end;
    }
  }

  /// The steps first .. end - 1 of a wall. Where it is cut, nobody has seen an end.
  static Wall piece_of(const Wall& wall, std::size_t first, std::size_t end, std::size_t steps) {
    Wall piece = wall;
    const Vec2 step = (wall.segment.end - wall.segment.start) / static_cast<double>(steps);
    if (first > 0) {
      piece.segment.start = wall.segment.start + static_cast<double>(first) * step;
      piece.start = WallEnd::kUnknown;
    }
    if (end < steps) {
      piece.segment.end = wall.segment.start + static_cast<double>(end) * step;
      piece.end = WallEnd::kUnknown;
    }
    return piece;
  }

  void keep(Wall piece, int before, int evidence) {
    piece.evidence = evidence;
    if (evidence > 0) walls_.push_back(piece);
    if (before == 0) {
      changed_.push_back({piece.segment, WallRefinement::kAdded});
    } else if (evidence == 0) {
      changed_.push_back({piece.segment, WallRefinement::kRemoved});
    } else if (evidence < before) {
      changed_.push_back({piece.segment, WallRefinement::kDoubted});
    } else if (before < kCertainEvidence && evidence >= kCertainEvidence) {
      changed_.push_back({piece.segment, WallRefinement::kAssured});
    }
  }

  /// Moves a wall's line towards where the trip saw it. Both are weighed in trips: the wall by what it is
  /// known to, at most so many as are remembered, the trip by how much of the wall it saw.
  void correct(Wall& wall) {
    const LineResiduals residuals(wall, now_, T_map_trip_);
    if (residuals.seen_share() <= 0) return;
    const double remembered = params_.trips_remembered;
    const double known = wall.sigma_m > 0 ? square(params_.trip_sigma_m / wall.sigma_m) : remembered;
    const double before = std::min(known, remembered), weight = residuals.seen_share();
    const double share = weight / (before + weight);
    const auto [off_m, turn_rad] = residuals.fit(!wall.is_orthogonal);
    const Vec2 middle = wall.segment.midpoint(), half = (wall.segment.end - wall.segment.start) / 2;
    const Vec2 aside = left_normal(half.normalized()) * (share * off_m);
    const Vec2 turned = rotation(share * turn_rad) * half;
    wall.segment = {middle + aside - turned, middle + aside + turned};
    wall.sigma_m = params_.trip_sigma_m / std::sqrt(std::min(before + weight, remembered));
    corrected_m_ += 2 * half.norm();
    squares_ += 2 * half.norm() * aside.squaredNorm();
  }

  const RefinementParams& params_;
  MapPattern before_;
  MapPattern now_;
  Pose2 T_map_trip_;  ///< what all walls are off together is the trip's, and does not move the frame
  std::vector<Wall> walls_;
  std::vector<RefinedWall> changed_;
  double corrected_m_ = 0;
  double squares_ = 0;
};

}  // namespace

void RefinementParams::describe(FieldList& fields) {
  fields.real("trip_sigma_m", trip_sigma_m, {0.001, 0.2},
              "standard deviation of a wall's position as one trip shows it");
  fields.count("trips_remembered", trips_remembered, {1, 1000},
               "a wall's position weighs no more than so many trips");
  fields.real("denied_m", denied_m, {0.15, 1}, "free floor this far from everything denies a wall");
  fields.real("common_min_m", common_min_m, {1, 1000},
              "walls that a trip must have in common with the building");
  fields.real("agreement_min", agreement_min, {0, 1},
              "share of the walls in sight of both that both must have");
}

double RefinedBuilding::length_m(WallRefinement what) const {
  double sum_m = 0;
  for (const RefinedWall& wall : walls) sum_m += wall.what == what ? wall.segment.length() : 0;
  return sum_m;
}

bool is_of_building(const MapOverlap& overlap, const RefinementParams& params) {
  return overlap.common_m >= params.common_min_m && overlap.agreement() >= params.agreement_min;
}

RefinedBuilding refined_building(const Building& old, const Building& trip, const RefinementParams& params) {
  if (!old.floor || !trip.floor)
    throw std::invalid_argument("maps without a floor do not say what they have not seen");
  RefinedBuilding refined{.overlap = {}, .building = old, .walls = {}};
  const Building seen = in_cells_of(trip, old.floor->cell_m());
  Refinement refinement(old, seen, params);
  for (const Wall& wall : old.walls.walls) refinement.see_again(wall);
  for (const Wall& wall : seen.walls.walls) refinement.add_new(wall);
  std::move(refinement).finish(refined);
  refined.building.floor = refined_floor(*old.floor, *seen.floor);
  return refined;
}

}  // namespace aisle
