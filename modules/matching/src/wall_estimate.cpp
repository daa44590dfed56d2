#include "aisle/matching/wall_estimate.hpp"

#include <algorithm>
#include <cmath>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

constexpr double kAbsorbHeading_rad = 6 * kDegree;
constexpr double kKindChange_rad = 5 * kDegree;  // orthogonal and oblique walls merge only within this
constexpr double kOffsetScale_m = 0.1;           // cost of one wall against another: offset, heading, overlap
constexpr double kHeadingScale_rad = 0.05;
constexpr double kOverlapBonus = 0.3;
constexpr double kGoodOffsetWeight = 1 / (0.01 * 0.01);  // of one good sighting
constexpr double kGoodHeadingWeight = 1 / (0.018 * 0.018);

/// Moves the wall's line to the weighted mean of itself and the segment.
void average(const PlacedSegment& placed, double weight_cap, WallEstimate& wall) {
  const double offset_weight = 1 / (placed.sensed->sigma_offset_m * placed.sensed->sigma_offset_m);
  const double share = offset_weight / (wall.offset_weight + offset_weight);
  if (wall.is_oblique()) {
    const double heading_weight = 1 / (placed.sensed->sigma_heading_rad * placed.sensed->sigma_heading_rad);
    const double turn = heading_weight / (wall.heading_weight + heading_weight) *
                        wrap_angle(placed.heading_rad - wall.heading_rad);
    const Segment2 before = wall.segment();
    wall.anchor += share * (placed.centroid - wall.anchor);
    wall.set_heading(wrap_angle(wall.heading_rad + turn));
    wall.extent = wall.span_of(before);
    wall.heading_weight = std::min(wall.heading_weight + heading_weight, weight_cap * kGoodHeadingWeight);
  } else {
    wall.anchor += wall.normal * (share * wall.offset_of(placed.centroid));
  }
  wall.offset_weight = std::min(wall.offset_weight + offset_weight, weight_cap * kGoodOffsetWeight);
}

/// Extends the wall to the ends of the segment; the outermost end sets the kind of end.
void extend(const PlacedSegment& placed, WallEstimate& wall) {
  const Interval seen = wall.span_of(placed.segment);
  constexpr double kSameEnd_m = 0.05;
  if (seen.min < wall.extent.min - kSameEnd_m) {
    wall.start = placed.sensed->start;
  } else if (seen.min < wall.extent.min + kSameEnd_m && placed.sensed->start == WallEnd::kSeen) {
    wall.start = WallEnd::kSeen;
  }
  if (seen.max > wall.extent.max + kSameEnd_m) {
    wall.end = placed.sensed->end;
  } else if (seen.max > wall.extent.max - kSameEnd_m && placed.sensed->end == WallEnd::kSeen) {
    wall.end = WallEnd::kSeen;
  }
  wall.extent = wall.extent.united(seen);
}

WallEstimate new_wall(const PlacedSegment& placed, Facing facing) {
  const SensedSegment& sensed = *placed.sensed;
  WallEstimate wall;
  wall.facing = facing;
  wall.set_heading(facing == Facing::kOblique ? placed.heading_rad : heading_of(facing));
  wall.anchor = placed.centroid;
  wall.offset_weight = 1 / (sensed.sigma_offset_m * sensed.sigma_offset_m);
  wall.heading_weight = 1 / (sensed.sigma_heading_rad * sensed.sigma_heading_rad);
  wall.extent = wall.span_of(placed.segment);
  wall.start = sensed.start;
  wall.end = sensed.end;
  return wall;
}

}  // namespace

Facing facing_of(double heading_rad, double tolerance_rad) {
  const double off = wrap_quarter_turn(heading_rad);
  if (std::abs(off) > tolerance_rad) return Facing::kOblique;
  const auto quarter_turns = static_cast<int>(std::lround((heading_rad - off) / (kPi / 2)));
  return static_cast<Facing>(((quarter_turns % 4) + 4) % 4);
}

double heading_of(Facing facing) {
  return wrap_angle(static_cast<int>(facing) * kPi / 2);
}

Interval WallEstimate::span_of(const Segment2& s) const {
  const double a = along.dot(s.start - anchor);
  const double b = along.dot(s.end - anchor);
  return {std::min(a, b), std::max(a, b)};
}

void WallEstimate::set_heading(double heading) {
  heading_rad = heading;
  along = unit(heading);
  normal = left_normal(along);
}

PlacedSegment::PlacedSegment(const SensedSegment& seen, const Pose2& T_map_sensor)
    : sensed(&seen),
      segment(T_map_sensor * seen.segment),
      centroid(T_map_sensor * seen.centroid),
      heading_rad(wrap_angle(T_map_sensor.theta + seen.heading_rad)) {}

int associate(const PlacedSegment& placed, std::span<const WallEstimate> walls,
              std::span<const int> candidates, const AssociationGate& gate) {
  const double length_m = placed.sensed->length_m;
  const double heading_gate = gate.heading_rad + 2 * placed.sensed->sigma_heading_rad;
  int best = -1;
  double best_cost = 1e18;
  for (const int index : candidates) {
    const WallEstimate& wall = walls[static_cast<std::size_t>(index)];
    const double offset_m = wall.offset_of(placed.centroid);
    if (std::abs(offset_m) > gate.offset_m) continue;
    const double turn = wrap_angle(placed.heading_rad - wall.heading_rad);
    if (std::abs(turn) > heading_gate) continue;
    const double overlap_m = wall.extent.overlap(wall.span_of(placed.segment));
    if (overlap_m < gate.overlap_min_m && overlap_m < 0.3 * length_m) continue;
    const double cost = offset_m * offset_m / (kOffsetScale_m * kOffsetScale_m) +
                        turn * turn / (kHeadingScale_rad * kHeadingScale_rad) -
                        kOverlapBonus * std::min(overlap_m / length_m, 1.0);
    if (cost < best_cost) {
      best_cost = cost;
      best = index;
    }
  }
  return best;
}

int absorb(const PlacedSegment& placed, double path_m, const WallUpdateParams& params,
           std::vector<WallEstimate>& walls, std::vector<int>& candidates) {
  const Facing facing =
      placed.sensed->curved ? Facing::kOblique : facing_of(placed.heading_rad, params.axis_tolerance_rad);
  int index = associate(placed, walls, candidates, {params.gate_m, kAbsorbHeading_rad, -params.gap_m});
  if (index >= 0) {
    const WallEstimate& wall = walls[static_cast<std::size_t>(index)];
    const bool other_kind = (facing == Facing::kOblique) != wall.is_oblique();
    if (other_kind && std::abs(wrap_angle(placed.heading_rad - wall.heading_rad)) > kKindChange_rad)
      index = -1;
  }
  if (index < 0) {
    index = static_cast<int>(walls.size());
    walls.push_back(new_wall(placed, facing));
    candidates.push_back(index);
  } else {
    average(placed, params.weight_cap, walls[static_cast<std::size_t>(index)]);
    extend(placed, walls[static_cast<std::size_t>(index)]);
  }
  WallEstimate& wall = walls[static_cast<std::size_t>(index)];
  ++wall.sightings;
  wall.last_seen_m = path_m;
  return index;
}

}  // namespace aisle
