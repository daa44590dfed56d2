#include <gtest/gtest.h>

#include "aisle/guidance/paths/braking_clearance.hpp"
#include "free_floor.hpp"

namespace aisle {
namespace {

const KnownFloor kHall = free_floor({{Vec2(0, 0), Vec2(10, 4)}});

BrakingClearance braking_seeing(const std::vector<float>& ranges_m) {
  BrakingClearance braking(cart(), 0.02);
  braking.see(kGeometry, ranges_m);
  return braking;
}

bool may_drive(const BrakingClearance& braking, const Pose2& T_map_vehicle, const Command& command) {
  return braking.is_free(kHall, T_map_vehicle, command, command.steering_rad);
}

TEST(BrakingClearance, StopsInTimeBeforeUnknownFloor) {
  const BrakingClearance braking = braking_seeing({});
  EXPECT_TRUE(may_drive(braking, {8.6, 2, 0}, {.speed_mps = 0.4}));
  EXPECT_FALSE(may_drive(braking, {8.95, 2, 0}, {.speed_mps = 0.4}));
  EXPECT_FALSE(may_drive(braking, {0.35, 2, 0}, {.speed_mps = -0.3}));
}

TEST(BrakingClearance, NeedsMoreClearanceAtHigherSpeed) {
  const BrakingClearance braking = braking_seeing({});
  EXPECT_TRUE(may_drive(braking, {8.86, 2, 0}, {.speed_mps = 0.1}));
  EXPECT_FALSE(may_drive(braking, {8.86, 2, 0}, {.speed_mps = 0.5}));
}

TEST(BrakingClearance, StopsBeforeLaserReturnsThatTheFloorDoesNotShow) {
  std::vector<float> ranges_m(181, 5);
  const BrakingClearance free = braking_seeing(ranges_m);
  ranges_m[90] = 0.12F;
  const BrakingClearance blocked = braking_seeing(ranges_m);
  EXPECT_TRUE(may_drive(free, {4, 2, 0}, {.speed_mps = 0.4}));
  EXPECT_FALSE(may_drive(blocked, {4, 2, 0}, {.speed_mps = 0.4}));
  EXPECT_TRUE(may_drive(blocked, {4, 2, 0}, {.speed_mps = -0.3}));
}

/// At 0.6 m from the wall the cart's front corner touches it when it is turned by 25 degrees.
TEST(BrakingClearance, TurnsOnTheSpotOnlyAsFastAsItCouldStopItsCorners) {
  const BrakingClearance braking(differential_cart(), 0.02);
  const Pose2 T_map_vehicle{5, 3.4, 0};
  EXPECT_TRUE(may_drive(braking, T_map_vehicle, {.turn_rate_rad_s = 20 * kDegree}));
  EXPECT_FALSE(may_drive(braking, T_map_vehicle, {.turn_rate_rad_s = 90 * kDegree}));
}

TEST(BrakingClearance, IgnoresUnusableReadings) {
  EXPECT_TRUE(may_drive(braking_seeing(std::vector<float>(181, 0)), {4, 2, 0}, {.speed_mps = 0.4}));
}

TEST(BrakingClearance, TooNearAWallItMayDriveAlongItButNotNearer) {
  const BrakingClearance braking = braking_seeing({});
  const Pose2 T_map_vehicle{5, 0.305, 0};
  EXPECT_TRUE(may_drive(braking, T_map_vehicle, {.speed_mps = 0.1}));
  EXPECT_FALSE(may_drive(braking, T_map_vehicle, {.speed_mps = 0.4, .steering_rad = -30 * kDegree}));
}

/// Brought to where it stands, it may have come over floor that it does not see.
TEST(BrakingClearance, OnItsTrailUnseenFloorDoesNotStopIt) {
  const BrakingClearance braking = braking_seeing({});
  const Command back{.speed_mps = -0.1};
  EXPECT_FALSE(braking.is_free(kHall, {0.3, 2, 0}, back, 0));
  EXPECT_TRUE(braking.is_free_on_trail(kHall, {0.3, 2, 0}, back, 0));
}

TEST(BrakingClearance, OnItsTrailItMayComeNearToObstaclesBesideIt) {
  KnownFloor hall = free_floor({{Vec2(0, 0), Vec2(10, 4)}});
  for (int x = 0; x < 200; ++x) occupy(hall, {x, 0});
  const BrakingClearance braking = braking_seeing({});
  const Pose2 T_map_vehicle{5, 0.385, 0};
  const Command swings_its_front_out{.speed_mps = -0.1, .steering_rad = 20 * kDegree};
  const auto may_go_back = [&] {
    return braking.is_free_on_trail(hall, T_map_vehicle, swings_its_front_out,
                                    swings_its_front_out.steering_rad);
  };
  EXPECT_FALSE(braking.is_free(hall, T_map_vehicle, swings_its_front_out, swings_its_front_out.steering_rad));
  EXPECT_TRUE(may_go_back());
  occupy(hall, hall.grid().cell_at({4.72, 0.385}));
  EXPECT_FALSE(may_go_back());
}

}  // namespace
}  // namespace aisle
