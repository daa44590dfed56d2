#include "aisle/guidance/free_steering.hpp"

#include <gmock/gmock.h>

#include <vector>

#include "cart.hpp"

namespace aisle {
namespace {

/// Points along a line.
std::vector<Vec2> wall(const Vec2& from, const Vec2& to) {
  std::vector<Vec2> points;
  for (int i = 0; i <= 50; ++i) points.push_back(from + i / 50.0 * (to - from));
  return points;
}

TEST(FreeSteering, TheWishIsFollowedWhereNothingStands) {
  const SteeringChoice choice = choose_steering(cart(), {}, {}, 0.2);
  EXPECT_NEAR(choice.steering_rad, 0.2, 1e-12);
  EXPECT_DOUBLE_EQ(choice.free_m, FreeSteeringParams{}.reach_m);
}

TEST(FreeSteering, TheFreeWayEndsAMarginBeforeAWall) {
  const auto ahead = wall({1.75, -1}, {1.75, 1});
  const SteeringChoice straight = free_way(cart(), {}, ahead, 0, 1);
  EXPECT_NEAR(straight.free_m, 0.7, 0.06);  // 0.95 of the vehicle, 0.06 of margin
}

TEST(FreeSteering, TurnsAsideOfWhatStandsAheadOnOneSide) {
  const auto left = wall({1.9, 0.1}, {1.9, 0.8});
  EXPECT_LT(choose_steering(cart(), {}, left, 0).steering_rad, -2 * kDegree);
}

TEST(FreeSteering, WhatIsTooNearAlreadyMayBeLeftBehind) {
  const std::vector<Vec2> beside = {{0.3, 0.33}};
  EXPECT_GT(free_way(cart(), {}, beside, 0, 1).free_m, 1);
  EXPECT_LT(free_way(cart(), {}, beside, 30 * kDegree, 1).free_m, 0.5);
}

TEST(FreeSteering, BackwardsItLooksBehind) {
  const auto behind = wall({-0.75, -1}, {-0.75, 1});
  EXPECT_NEAR(free_way(cart(), {}, behind, 0, -1).free_m, 0.4, 0.06);
  EXPECT_DOUBLE_EQ(free_way(cart(), {}, behind, 0, 1).free_m, FreeSteeringParams{}.reach_m);
}

TEST(FreeSteering, BackwardsItKeepsOffWhatItsFrontWouldSwingTo) {
  const auto beside = wall({0.3, -0.4}, {0.95, -0.4});
  EXPECT_LT(free_way(cart(), {}, beside, 0.3, -1).free_m, 0.15) << "the front goes to the right";
  const SteeringChoice choice = choose_steering(cart(), {.comfort_m = 0.1}, beside, 0.3, -1);
  EXPECT_LT(choice.steering_rad, 0.1);
  EXPECT_GT(choice.free_m, 1);
}

}  // namespace
}  // namespace aisle
