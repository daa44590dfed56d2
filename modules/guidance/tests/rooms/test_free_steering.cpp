#include "aisle/guidance/rooms/free_steering.hpp"

#include <gmock/gmock.h>

#include <rapidcheck/gtest.h>
#include <algorithm>
#include <cmath>
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

TEST(FreeSteering, KeepsTheRequestedAngleWithoutObstacles) {
  const SteeringChoice choice = choose_steering(cart(), {}, {}, 0.2);
  EXPECT_NEAR(choice.steering_rad, 0.2, 1e-12);
  EXPECT_DOUBLE_EQ(choice.free_m, FreeSteeringParams{}.reach_m);
}

TEST(FreeSteering, TheFreePathEndsAMarginBeforeAWall) {
  const auto ahead = wall({1.75, -1}, {1.75, 1});
  const SteeringChoice straight = free_path(cart(), {}, ahead, 0, Gear::kForward);
  EXPECT_NEAR(straight.free_m, 0.7, 0.06);  // 0.95 of the vehicle, 0.06 of margin
}

TEST(FreeSteering, TurnsAwayFromAnObstacleAheadOnOneSide) {
  const auto left = wall({1.9, 0.1}, {1.9, 0.8});
  EXPECT_LT(choose_steering(cart(), {}, left, 0).steering_rad, -2 * kDegree);
}

TEST(FreeSteering, MayDriveAwayFromAnObstacleThatIsTooNear) {
  const std::vector<Vec2> beside = {{0.3, 0.33}};
  EXPECT_GT(free_path(cart(), {}, beside, 0, Gear::kForward).free_m, 1);
  EXPECT_LT(free_path(cart(), {}, beside, 30 * kDegree, Gear::kForward).free_m, 0.5);
}

TEST(FreeSteering, InReverseItLooksBehind) {
  const auto behind = wall({-0.75, -1}, {-0.75, 1});
  EXPECT_NEAR(free_path(cart(), {}, behind, 0, Gear::kReverse).free_m, 0.4, 0.06);
  EXPECT_DOUBLE_EQ(free_path(cart(), {}, behind, 0, Gear::kForward).free_m, FreeSteeringParams{}.reach_m);
}

TEST(FreeSteering, InReverseItKeepsItsSwingingFrontOffObstacles) {
  const auto beside = wall({0.3, -0.4}, {0.95, -0.4});
  EXPECT_LT(free_path(cart(), {}, beside, 0.3, Gear::kReverse).free_m, 0.15) << "the front goes to the right";
  const SteeringChoice choice = choose_steering(cart(), {.comfort_m = 0.1}, beside, 0.3, Gear::kReverse);
  EXPECT_LT(choice.steering_rad, 0.1);
  EXPECT_GT(choice.free_m, 1);
}

RC_GTEST_PROP(FreeSteering, NoPointIsOverlooked, ()) {
  const auto within = [](int most_cm) { return *rc::gen::inRange(-most_cm, most_cm + 1) / 100.0; };
  std::vector<Vec2> points(static_cast<std::size_t>(*rc::gen::inRange(1, 40)));
  for (Vec2& p : points) p = {within(400), within(400)};
  const double steering_rad = within(70);
  const Gear gear = *rc::gen::element(Gear::kReverse, Gear::kForward);
  const SteeringChoice choice =
      free_path(cart(), {.reach_m = 1.5, .margin_m = 0}, points, steering_rad, gear);
  double nearest_m = 10;
  for (int step = 0; step * 0.1 < choice.free_m + 0.05; ++step) {
    const double path_m = sign(gear) * step * 0.1;
    const double turn_rad = path_m * std::tan(steering_rad) / cart().front_steered.wheelbase_m;
    const Pose2 T_then_now = end_pose({path_m, turn_rad}).inverse();
    for (const Vec2& p : points)
      nearest_m = std::min(nearest_m, off_footprint_m(cart().footprint, T_then_now * p));
  }
  RC_ASSERT(std::abs(choice.clearance_m - nearest_m) < 1e-9);
}

}  // namespace
}  // namespace aisle
