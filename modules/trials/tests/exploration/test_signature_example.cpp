#include "exploration/signature_example.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace aisle {
namespace {

constexpr double kLength_m = 8, kWidth_m = 5;

/// A turn of one reading a degree in an empty room from (0, 0) to (8, 5).
LaserScan turn_in_the_room(const Pose2& T_map_vehicle) {
  LaserScan scan;
  for (int degree = 0; degree < 360; ++degree) {
    const Vec2 towards = unit(T_map_vehicle.theta + degree * kDegree);
    const double to_x = ((towards.x() > 0 ? kLength_m : 0) - T_map_vehicle.x) / towards.x();
    const double to_y = ((towards.y() > 0 ? kWidth_m : 0) - T_map_vehicle.y) / towards.y();
    scan.ranges_m.push_back(static_cast<float>(std::min(to_x, to_y)));
  }
  return scan;
}

WallMap room() {
  WallMap walls;
  const Vec2 corners[] = {{0, 0}, {kLength_m, 0}, {kLength_m, kWidth_m}, {0, kWidth_m}, {0, 0}};
  for (int i = 0; i < 4; ++i) walls.walls.push_back({.segment = {corners[i], corners[i + 1]}});
  return walls;
}

TEST(SignatureExample, TheViewIsCarriedBackOntoTheWalls) {
  const std::vector<Pose2> T_map_vehicle = {{3.3, 2.1, 0.4}};
  LaserLog log;
  log.laser() = {.first_angle_rad = 0, .angle_step_rad = kDegree, .range_max_m = 30};
  log.scans = {turn_in_the_room(T_map_vehicle.front())};
  const SignatureExample example = signature_example(log, T_map_vehicle, room(), {});
  EXPECT_GE(example.sensed.walls.size(), 4U);
  EXPECT_EQ(example.learned.walls.size(), 4U);
  EXPECT_GT(example.displaced_m.norm(), 0.1);
  EXPECT_LT((example.found_m + example.displaced_m).norm(), 0.03);
}

}  // namespace
}  // namespace aisle
