#include "aisle/vehicle/odometry_step.hpp"

#include <gtest/gtest.h>

namespace aisle {
namespace {

constexpr double kTolerance = 1e-12;

TEST(OdometryStep, StraightFrontWheelsCountTheDistance) {
  const Pose2 step = odometry_step({}, FrontSteeredMotion{.distance_m = 0.3, .steering_rad = 0});
  EXPECT_NEAR(step.x, 0.3, kTolerance);
  EXPECT_NEAR(step.y, 0, kTolerance);
  EXPECT_NEAR(step.theta, 0, kTolerance);
}

TEST(OdometryStep, WheelsThatCountAgainstEachOtherTurnOnTheSpot) {
  VehicleDescription vehicle;
  vehicle.is_differential = true;
  const Pose2 step = odometry_step(vehicle, WheelSteps{.left = -100, .right = 100});
  const double turn_rad =
      200 * vehicle.differential.step_length_m() / vehicle.differential.wheel_separation_m;
  EXPECT_NEAR(step.x, 0, kTolerance);
  EXPECT_NEAR(step.y, 0, kTolerance);
  EXPECT_NEAR(step.theta, turn_rad, kTolerance);
}

TEST(OdometryStep, OnlyFrontWheelsSteer) {
  EXPECT_EQ(steering_rad_of(FrontSteeredMotion{.distance_m = 0, .steering_rad = 0.2}), 0.2);
  EXPECT_EQ(steering_rad_of(WheelSteps{.left = 3, .right = 5}), 0);
}

}  // namespace
}  // namespace aisle
