#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "aisle/vehicle/odometry_step.hpp"
#include "joint_odometry.hpp"
#include "odometry_reading.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

VehicleDescription driven(bool is_differential) {
  VehicleDescription vehicle;
  vehicle.is_differential = is_differential;
  make_steps_fine(vehicle.differential);
  return vehicle;
}

/// A drive along arcs, as the poses of an odometry.
std::vector<Pose2> drive_of_arcs(const std::vector<int>& bends) {
  std::vector<Pose2> poses{{}};
  for (const int bend : bends)
    poses.push_back(poses.back() * end_pose({0.03 + 0.001 * (bend % 20), 0.004 * (bend % 23)}));
  return poses;
}

/// Reads a drive pose by pose, and drives what was read.
Pose2 reading_undone(const VehicleDescription& vehicle, const std::vector<Pose2>& poses) {
  OdometryReadings readings(vehicle, poses.front());
  Pose2 T;
  for (const Pose2& pose : poses) T = T * odometry_step(vehicle, readings.read(pose, 0));
  return T;
}

RC_GTEST_PROP(OdometryReading, WhatTheWheelsCountLeadsWhereTheOdometryLed, (std::vector<int> bends)) {
  const std::vector<Pose2> poses = drive_of_arcs(bends);
  for (const bool is_differential : {false, true}) {
    const Pose2 T = reading_undone(driven(is_differential), poses);
    RC_ASSERT((T.position() - poses.back().position()).norm() < 1e-3);
    RC_ASSERT(std::abs(wrap_angle(T.theta - poses.back().theta)) < 1e-3);
  }
}

TEST(OdometryReading, BackwardsIsNegative) {
  const VehicleDescription car = driven(false), cart = driven(true);
  OdometryReadings of_car(car, {}), of_cart(cart, {});
  const auto motion = std::get<FrontSteeredMotion>(of_car.read({-0.1, 0, 0}, 0));
  EXPECT_NEAR(motion.distance_m, -0.1, 1e-9);
  EXPECT_NEAR(motion.steering_rad, 0, 1e-9);
  const auto steps = std::get<WheelSteps>(of_cart.read({-0.1, 0, 0}, 0));
  EXPECT_EQ(steps.left, steps.right);
  EXPECT_NEAR(steps.left * cart.differential.step_length_m(), -0.1, 1e-4);
}

TEST(OdometryReading, ATurnOnTheSpotIsOne) {
  const VehicleDescription cart = driven(true);
  OdometryReadings readings(cart, {});
  const auto steps = std::get<WheelSteps>(readings.read({0, 0, 0.2}, 0));
  EXPECT_EQ(steps.left, -steps.right);
  EXPECT_GT(steps.right, 0);
}

TEST(OdometryReading, StandingWheelsKeepTheirSteering) {
  const VehicleDescription car = driven(false);
  OdometryReadings readings(car, {});
  const auto motion = std::get<FrontSteeredMotion>(readings.read({}, 0.3));
  EXPECT_EQ(motion.distance_m, 0);
  EXPECT_EQ(motion.steering_rad, 0.3);
}

ros::JointState wheels_at(double left_rad, double right_rad) {
  ros::JointState message;
  message.name = {"arm", "right", "left"};
  message.position = {9, right_rad, left_rad};
  return message;
}

TEST(JointOdometry, SumsUpTheAnglesOfItsTwoJoints) {
  ConnectedOdometry odometry;
  odometry.left_joint = "left";
  odometry.right_joint = "right";
  Differential wheels;
  wheels.wheel_radius_m = 0.1;
  wheels.wheel_separation_m = 0.4;
  JointOdometry summed(odometry, wheels);
  EXPECT_THAT(*summed.take(wheels_at(5, 7)), PoseNear(Pose2{}, 0, 0));
  EXPECT_THAT(*summed.take(wheels_at(7, 9)), PoseNear(Pose2{0.2, 0, 0}, 1e-9, 1e-9));
  EXPECT_THAT(*summed.take(wheels_at(5, 11)), PoseNear(Pose2{0.2, 0, 1}, 1e-9, 1e-9));
}

TEST(JointOdometry, OtherJointsTellNothing) {
  JointOdometry summed(ConnectedOdometry{}, Differential{});
  EXPECT_FALSE(summed.take(wheels_at(1, 1)));
}

}  // namespace
}  // namespace aisle
