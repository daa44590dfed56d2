#include "aisle/maps/barrier.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace aisle {
namespace {

/// The interval of a segment's parameter, 0 .. 1 from start to end, in which one coordinate lies between two
/// limits; empty: min > max.
Interval share_between(double start, double end, double low, double high) {
  const double along = end - start;
  if (along == 0) return start >= low && start <= high ? Interval{0, 1} : Interval{1, 0};
  const auto [first, last] = std::minmax({(low - start) / along, (high - start) / along});
  return {std::max(0.0, first), std::min(1.0, last)};
}

int floor_index(double coordinate) {
  constexpr double kReach = FloorGrid::kReach;
  return static_cast<int>(std::clamp(std::floor(coordinate), -kReach - 1, kReach + 1));
}

}  // namespace

const char* words_for(Barrier::Kind kind) {
  return kind == Barrier::Kind::kGlass ? "glass" : "keep-out line";
}

bool meets(const Footprint& footprint, const Segment2& segment) {
  const Interval along =
      share_between(segment.start.x(), segment.end.x(), -footprint.rear_m, footprint.front_m);
  const Interval across =
      share_between(segment.start.y(), segment.end.y(), -footprint.width_m / 2, footprint.width_m / 2);
  return std::max(along.min, across.min) <= std::min(along.max, across.max);
}

const Barrier* barrier_met(std::span<const Barrier> barriers, const Footprint& footprint,
                           const Pose2& T_map_vehicle) {
  const Pose2 T_vehicle_map = T_map_vehicle.inverse();
  const auto met = std::find_if(barriers.begin(), barriers.end(), [&](const Barrier& barrier) {
    return meets(footprint, T_vehicle_map * barrier.segment);
  });
  return met == barriers.end() ? nullptr : &*met;
}

std::vector<FloorCell> cells_under(const Segment2& segment, double cell_m) {
  const bool rises = segment.start.y() <= segment.end.y();
  const Vec2 low = (rises ? segment.start : segment.end) / cell_m;
  const Vec2 high = (rises ? segment.end : segment.start) / cell_m;
  constexpr int kReach = FloorGrid::kReach;
  std::vector<FloorCell> cells;
  for (int y = std::max(-kReach, floor_index(low.y())); y <= std::min(kReach, floor_index(high.y())); ++y) {
    const Interval in_row = share_between(low.y(), high.y(), y, y + 1);
    const auto [left, right] = std::minmax(
        {low.x() + in_row.min * (high.x() - low.x()), low.x() + in_row.max * (high.x() - low.x())});
    for (int x = std::max(-kReach, floor_index(left)); x <= std::min(kReach, floor_index(right)); ++x)
      cells.push_back({x, y});
  }
  return cells;
}

}  // namespace aisle
