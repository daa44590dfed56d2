#include "exploration/footprint_reach.hpp"

#include <cmath>
#include <cstdint>
#include <unordered_set>
#include <utility>

#include "aisle/guidance/paths/footprint_clearance.hpp"
#include "aisle/vehicle/arc.hpp"

namespace aisle {
namespace {

constexpr double kCell_m = 0.025;
constexpr double kClearanceMax_m = 0.6;
constexpr double kStep_m = 0.25;
constexpr double kSpotTurn_rad = 12 * kDegree;
constexpr int kChecks = 2;  // along a step
constexpr double kFloorAround_m = 1;

/// Bins of poses.
struct PoseBins {
  double place_m;
  int headings;

  std::uint64_t of(const Pose2& T) const {
    constexpr double kOffset = 1 << 20;
    const auto x = static_cast<std::uint64_t>(std::floor(T.x / place_m) + kOffset);
    const auto y = static_cast<std::uint64_t>(std::floor(T.y / place_m) + kOffset);
    const auto heading = static_cast<std::uint64_t>(std::floor((T.theta + kPi) / (2 * kPi) * headings));
    return x << 40U | y << 16U | heading;
  }
};

constexpr PoseBins kDrivenBins{0.12, 36};
constexpr PoseBins kReportedBins{0.4, 8};

/// A floor that is free except for the obstacles.
KnownFloor true_floor(std::span<const Segment2> obstacles) {
  FloorGrid grid(kCell_m);
  FloorBox box;
  for (const Segment2& s : obstacles) {
    box.include(grid.cell_at(s.start));
    box.include(grid.cell_at(s.end));
  }
  box = box.widened(static_cast<int>(kFloorAround_m / kCell_m));
  for (int y = box.low.y; y < box.end.y; ++y) {
    for (int x = box.low.x; x < box.end.x; ++x) grid.set({x, y}, Floor::kFree);
  }
  for (const Segment2& s : obstacles) {
    const int steps = static_cast<int>(std::ceil(2 * s.length() / kCell_m)) + 1;
    for (int i = 0; i <= steps; ++i)
      grid.set(grid.cell_at(Vec2(s.start + (s.end - s.start) * i / steps)), Floor::kOccupied);
  }
  return KnownFloor(std::move(grid), FloorClearance(kClearanceMax_m));
}

std::vector<Arc> steps_of(const VehicleDescription& vehicle) {
  if (vehicle.is_differential) return {{kStep_m, 0}, {-kStep_m, 0}, {0, kSpotTurn_rad}, {0, -kSpotTurn_rad}};
  const double bend_per_m = std::tan(vehicle.limits.steering_max_rad) / vehicle.front_steered.wheelbase_m;
  std::vector<Arc> steps;
  for (const double length_m : {kStep_m, -kStep_m}) {
    for (const double share : {0.0, 0.5, -0.5, 1.0, -1.0})
      steps.push_back({length_m, share * bend_per_m * length_m});
  }
  return steps;
}

}  // namespace

std::vector<Pose2> poses_in_reach(std::span<const Segment2> obstacles, const VehicleDescription& vehicle,
                                  const Pose2& T_world_start, double margin_m) {
  const KnownFloor floor = true_floor(obstacles);
  const FootprintClearance footprint(vehicle.footprint, margin_m);
  const std::vector<Arc> steps = steps_of(vehicle);
  const auto is_free = [&](const Pose2& T, const Arc& step) {
    for (int i = kChecks; i > 0; --i) {
      const double share = static_cast<double>(i) / kChecks;
      if (!footprint.fits(floor, T * end_pose({share * step.length_m, share * step.turn_rad}))) return false;
    }
    return true;
  };
  std::unordered_set<std::uint64_t> driven = {kDrivenBins.of(T_world_start)};
  std::unordered_set<std::uint64_t> reported = {kReportedBins.of(T_world_start)};
  std::vector<Pose2> open = {T_world_start}, poses = {T_world_start};
  while (!open.empty()) {
    const Pose2 T = open.back();
    open.pop_back();
    for (const Arc& step : steps) {
      const Pose2 T_next = T * end_pose(step);
      if (driven.contains(kDrivenBins.of(T_next)) || !is_free(T, step)) continue;
      driven.insert(kDrivenBins.of(T_next));
      open.push_back(T_next);
      if (reported.insert(kReportedBins.of(T_next)).second) poses.push_back(T_next);
    }
  }
  return poses;
}

}  // namespace aisle
