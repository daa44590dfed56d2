#include "aisle/exploration/pockets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "aisle/core/angle.hpp"
#include "frontier_cells.hpp"

namespace aisle {
namespace {

constexpr int kDarkCells = 3;                 // behind the edge, all unknown
constexpr double kBesideUnknownCells = 0.75;  // cells with less clearance border on the unknown
constexpr double kBeyondFrontier_m = 0.3;     // depth of the unknown that a frontier surely leads to
constexpr std::size_t kLooksMax = 6;          // points of an edge from which lines of sight are cast ...
constexpr std::size_t kSights = 96;           // ... in this many directions: doors may be hardly open
constexpr std::size_t kPocketRimMax = 24;     // points that represent an edge
constexpr double kSightMin_m = 0.8;           // the vehicle's centre does not come nearer
constexpr double kStraightest = 0.98;         // a measured path is at least this much of the straight line
constexpr double kStrideMax_m = 0.2;          // along a line of sight, over free floor
constexpr std::array<FloorCell, 4> kBeside = {{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

/// Indices of at most `most` out of `count`, evenly spread.
std::vector<std::size_t> spread(std::size_t count, std::size_t most) {
  const std::size_t every = count / most + 1;
  std::vector<std::size_t> chosen;
  for (std::size_t i = (count - 1) % every / 2; i < count; i += every) chosen.push_back(i);
  return chosen;
}

std::array<Vec2, kSights> all_round() {
  std::array<Vec2, kSights> directions;
  for (std::size_t k = 0; k < kSights; ++k)
    directions[k] = unit(2 * kPi * static_cast<double>(k) / static_cast<double>(kSights));
  return directions;
}

class PocketFinder {
 public:
  PocketFinder(const KnownFloor& floor, const FloorDistances& reached, const FrontierParams& frontier_params,
               const PocketParams& params, CellMarks& marks)
      : floor_(floor.grid()),
        clearance_(floor.clearance()),
        reached_(reached),
        frontier_params_(frontier_params),
        params_(params),
        marks_(marks) {
    marks_.assign(clearance_.size(), kNothing);
  }

  std::vector<Frontier> find(std::span<const Frontier> frontiers) {
    for (const Frontier& frontier : frontiers) mark_led_to(frontier);
    std::vector<FloorCell> edges = mark_edges();
    const auto cells_min = static_cast<std::size_t>(std::lround(params_.edge_min_m / floor_.cell_m()));
    std::vector<Frontier> pockets;
    for (const FloorCell cell : edges) {
      if (marks_[clearance_.index(cell)] != kEdge) continue;
      Frontier pocket = gather(cell);
      if (pocket.cells.size() >= cells_min && find_stand(pocket)) pockets.push_back(std::move(pocket));
    }
    return pockets;
  }

 private:
  enum Mark : std::uint8_t { kNothing, kLedTo, kEdge, kTaken };

  bool may_be_floor(FloorCell cell) const {
    return clearance_.to_occupied_m(cell) >= frontier_params_.clearance_m + frontier_params_.uncertain_m;
  }

  /// Marks what may be floor behind a frontier, along the edge of the known floor.
  void mark_led_to(const Frontier& frontier) {
    struct LedTo {
      FloorCell cell;
      int beyond;  ///< cells beyond the last free one
    };
    const int beyond_max = static_cast<int>(kBeyondFrontier_m / floor_.cell_m());
    std::vector<LedTo> steps;
    for (const FloorCell cell : frontier.cells) steps.push_back({cell, 0});
    for (std::size_t i = 0; i < steps.size(); ++i) {
      for (const FloorCell step : kBeside) {
        const FloorCell next{steps[i].cell.x + step.x, steps[i].cell.y + step.y};
        if (!clearance_.room().contains(next) || marks_[clearance_.index(next)] == kLedTo) continue;
        const bool is_sure = clearance_.to_doubtful_m(next) >= frontier_params_.clearance_m;
        if (is_sure || !may_be_floor(next)) continue;
        const int beyond = floor_.at(next) == Floor::kFree ? 0 : steps[i].beyond + 1;
        if (beyond > beyond_max) continue;
        marks_[clearance_.index(next)] = kLedTo;
        steps.push_back({next, beyond});
      }
    }
  }

  /// The first unknown cell next to a free one, in one of the four directions. No deeper: lines of sight
  /// along an edge that limited the view enter the unknown at small angles.
  std::optional<FloorCell> dark_beside(FloorCell cell) const {
    for (const FloorCell step : kBeside) {
      bool is_dark = true;
      for (int i = 1; i <= kDarkCells && is_dark; ++i)
        is_dark = floor_.at(FloorCell{cell.x + i * step.x, cell.y + i * step.y}) == Floor::kUnknown;
      if (is_dark) return FloorCell{cell.x + step.x, cell.y + step.y};
    }
    return std::nullopt;
  }

  bool is_led_to(FloorCell cell) const {
    const int reach = static_cast<int>(frontier_params_.clearance_m / floor_.cell_m());
    for (int y = -reach; y <= reach; y += 2) {
      for (int x = -reach; x <= reach; x += 2) {
        const FloorCell near{cell.x + x, cell.y + y};
        if (clearance_.room().contains(near) && marks_[clearance_.index(near)] == kLedTo) return true;
      }
    }
    return false;
  }

  std::vector<FloorCell> mark_edges() {
    std::vector<FloorCell> edges;
    const double beside_unknown_m = kBesideUnknownCells * floor_.cell_m();
    clearance_.for_cells(floor_.known(), [&](FloorCell cell, std::size_t index) {
      if (clearance_.to_doubtful_m(index) > beside_unknown_m) return;
      if (floor_.at(cell) == Floor::kFree && dark_beside(cell) && !is_led_to(cell)) edges.push_back(cell);
    });
    for (const FloorCell cell : edges) marks_[clearance_.index(cell)] = kEdge;
    return edges;
  }

  Frontier gather(FloorCell first) {
    Frontier pocket;
    pocket.is_pocket = true;
    pocket.cells.push_back(first);
    marks_[clearance_.index(first)] = kTaken;
    for (std::size_t i = 0; i < pocket.cells.size(); ++i) {
      const FloorCell cell = pocket.cells[i];
      for (int y = cell.y - 1; y <= cell.y + 1; ++y) {
        for (int x = cell.x - 1; x <= cell.x + 1; ++x) {
          const std::size_t next = clearance_.index({x, y});
          if (marks_[next] != kEdge) continue;
          marks_[next] = kTaken;
          pocket.cells.push_back({x, y});
        }
      }
    }
    measure_frontier_cells(floor_, pocket);
    pocket.behind_m2 = static_cast<double>(kDarkCells) * static_cast<double>(pocket.cells.size()) *
                       floor_.cell_m() * floor_.cell_m();
    for (const std::size_t i : spread(pocket.cells.size(), kPocketRimMax))
      pocket.edge.push_back(floor_.centre(*dark_beside(pocket.cells[i])));
    return pocket;
  }

  /// The nearest place to the vehicle with a line of sight to part of the edge.
  bool find_stand(Frontier& pocket) const {
    pocket.path_m = FloorDistances::kUnreached;
    for (const std::size_t i : spread(pocket.edge.size(), kLooksMax)) {
      for (const Vec2& direction : directions_) look_back(pocket.edge[i], direction, pocket);
    }
    return pocket.path_m < FloorDistances::kUnreached;
  }

  /// Whether a path to any place on this line of sight is longer than one that is known already: no path is
  /// shorter than the straight line.
  bool is_farther(const Vec2& p_map, const Vec2& direction, double path_m) const {
    const Vec2 to_start_m = floor_.centre(reached_.start()) - p_map;
    const Vec2 nearest_m = std::clamp(to_start_m.dot(direction), kSightMin_m, params_.reach_m) * direction;
    return kStraightest * (to_start_m - nearest_m).norm() - floor_.cell_m() > path_m;
  }

  void look_back(const Vec2& p_map, const Vec2& direction, Frontier& pocket) const {
    if (is_farther(p_map, direction, pocket.path_m)) return;
    for (double along_m = 0; along_m < params_.reach_m;) {
      const FloorCell cell = floor_.cell_at(Vec2(p_map + along_m * direction));
      const Floor kind = floor_.at(cell);
      if (kind == Floor::kOccupied || (kind == Floor::kUnknown && along_m > Frontier::kPocketDepth_m)) return;
      if (along_m >= kSightMin_m && reached_.to(cell) < pocket.path_m) {
        pocket.path_m = reached_.to(cell);
        pocket.viewpoint = cell;
      }
      along_m += std::clamp(clearance_.to_doubtful_m(cell) - floor_.cell_m(), floor_.cell_m(), kStrideMax_m);
    }
  }

  const FloorGrid& floor_;
  const FloorClearance& clearance_;
  const FloorDistances& reached_;
  const FrontierParams& frontier_params_;
  const PocketParams& params_;
  CellMarks& marks_;
  const std::array<Vec2, kSights> directions_ = all_round();
};

}  // namespace

void PocketParams::describe(FieldList& fields) {
  fields.real("edge_min_m", edge_min_m, {0.1, 100}, "least length of a pocket's edge");
  fields.real("reach_m", reach_m, {1, 20}, "a pocket is looked into from at most this far");
  fields.real("path_max_m", path_max_m, {0, 1000},
              "a pocket farther away waits until the vehicle comes by; 0: all are ignored");
  fields.real("path_max_m_per_m2", path_max_m_per_m2, {0, 1e6},
              "the same limit by the area that it hides along its edge; the greater limit counts");
  fields.real("again_m2", again_m2, {0, 1e6},
              "a pocket that hides this much along its edge is looked into once more, from elsewhere or with "
              "more known");
}

std::vector<Frontier> find_pockets(const KnownFloor& floor, const FloorDistances& reached,
                                   std::span<const Frontier> frontiers, const FrontierParams& frontier_params,
                                   const PocketParams& params, CellMarks& marks) {
  return PocketFinder(floor, reached, frontier_params, params, marks).find(frontiers);
}

}  // namespace aisle
