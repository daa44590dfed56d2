#include "aisle/learning/walls/floor_of_log.hpp"

#include <cmath>
#include <optional>

#include "aisle/core/angle.hpp"
#include "aisle/maps/floor_view.hpp"

namespace aisle {
namespace {

constexpr double kLookEvery_m = 0.2;
constexpr double kLookEvery_rad = 10 * kDegree;
constexpr double kLookReach_m = 8;

}  // namespace

FloorGrid floor_of_log(const LaserLog& log, std::span<const Pose2> T_map_vehicle) {
  FloorGrid floor;
  std::optional<Pose2> T_map_last;
  for (std::size_t i = 0; i < log.scans.size(); ++i) {
    const Pose2& T = T_map_vehicle[i];
    if (T_map_last) {
      const Pose2 moved = between(*T_map_last, T);
      if (moved.position().norm() < kLookEvery_m && std::abs(moved.theta) < kLookEvery_rad) continue;
    }
    T_map_last = T;
    const LaserScan& scan = log.scans[i];
    floor.pass_time(scan.time_s);
    see_floor(floor, log.laser_of(scan), scan.ranges_m, {}, T, {.reach_m = kLookReach_m}, Viewpoint::kMoved);
  }
  floor.forget_dynamic();
  return floor;
}

}  // namespace aisle
