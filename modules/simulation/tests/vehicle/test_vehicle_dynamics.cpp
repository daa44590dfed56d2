#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "aisle/core/random.hpp"
#include "aisle/simulation/vehicle/vehicle_dynamics.hpp"
#include "plain_vehicles.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

constexpr double kTick_s = 0.01;

struct Driven {
  Pose2 T_start_end;
  double front_distance_m = 0;
};

Driven drive_for(const VehicleDescription& vehicle, VehicleDynamics& dynamics, const Command& command,
                 double time_s) {
  Driven run;
  for (int i = 0; i < std::lround(time_s / kTick_s); ++i) {
    const Travel travel = dynamics.step(command, kTick_s);
    run.T_start_end = run.T_start_end * end_pose(arc_of(vehicle, travel));
    run.front_distance_m += travel.distance_m;
  }
  return run;
}

/// Steers and gets up to speed first, then drives with controls that stay.
Pose2 drive_constantly(const VehicleDescription& vehicle, const Command& command, double time_s) {
  VehicleDynamics dynamics(vehicle);
  drive_for(vehicle, dynamics, command, 5);
  return drive_for(vehicle, dynamics, command, time_s).T_start_end;
}

TEST(VehicleDynamics, GetsFasterEvenlyAndBrakesEvenly) {
  VehicleDynamics dynamics(
      front_steered());  // 0.5 m/s^2 to 0.8 m/s: 1.6 s and 0.64 m; 1.5 m/s^2 back: 0.213 m
  EXPECT_NEAR(drive_for(front_steered(), dynamics, {.speed_mps = 0.8}, 1.6).T_start_end.x, 0.64, 1e-9);
  EXPECT_NEAR(dynamics.state().speed_mps, 0.8, 1e-12);
  EXPECT_NEAR(drive_for(front_steered(), dynamics, {}, 2).T_start_end.x, 0.8 * 0.8 / 2 / 1.5, 1e-3);
  EXPECT_EQ(dynamics.state().speed_mps, 0);
}

TEST(VehicleDynamics, HoldsItsLimitsWhateverItIsCommanded) {
  VehicleDynamics dynamics(front_steered());
  drive_for(front_steered(), dynamics, {.speed_mps = 50, .steering_rad = 2}, 5);
  EXPECT_DOUBLE_EQ(dynamics.state().speed_mps, 1);
  EXPECT_DOUBLE_EQ(dynamics.state().steering_rad, 40 * kDegree);
  drive_for(front_steered(), dynamics, {.speed_mps = -50, .steering_rad = -2}, 8);
  EXPECT_DOUBLE_EQ(dynamics.state().speed_mps, -0.5);
  EXPECT_DOUBLE_EQ(dynamics.state().steering_rad, -40 * kDegree);
}

TEST(VehicleDynamics, TheSteeringTurnsAtItsRate) {
  VehicleDynamics dynamics(front_steered());  // 60 degrees a second
  drive_for(front_steered(), dynamics, {.steering_rad = 30 * kDegree}, 0.25);
  EXPECT_NEAR(dynamics.state().steering_rad, 15 * kDegree, 1e-9);
}

TEST(VehicleDynamics, StandsBeforeItTurnsRound) {
  VehicleDynamics dynamics(front_steered());
  drive_for(front_steered(), dynamics, {.speed_mps = 0.01}, 1);
  dynamics.step({.speed_mps = -0.5}, 0.1);
  EXPECT_EQ(dynamics.state().speed_mps, 0);
}

TEST(VehicleDynamics, StraightOnEndsWhereItShould) {
  EXPECT_THAT(drive_constantly(front_steered(), {.speed_mps = 0.5}, 20),
              PoseNear(Pose2{10, 0, 0}, 1e-9, 1e-9));
}

TEST(VehicleDynamics, AFullCircleEndsWhereItBegan) {
  // Wheels at 30 degrees, 0.75 m before the rear axle: the front runs on a circle of 1.5 m.
  const double time_s = 2 * kPi * 1.5 / 0.3;
  const Command command{.speed_mps = 0.3, .steering_rad = 30 * kDegree};
  const double whole_s = std::floor(time_s / kTick_s) * kTick_s;
  const Pose2 rest = drive(FrontSteered{0.75}, {0.3 * (time_s - whole_s), 30 * kDegree});
  EXPECT_THAT(drive_constantly(front_steered(), command, whole_s) * rest, PoseNear(Pose2{}, 1e-9, 1e-9));
}

TEST(VehicleDynamics, ReversingAroundAQuarterCircleEndsWhereItShould) {
  // The rear axle's middle runs backwards about (0, r), r = 0.75 m / tan 30 deg.
  const double r = 0.75 / std::tan(30 * kDegree), arc_m = kPi / 2 * 1.5;
  const double time_s = std::floor(arc_m / 0.2 / kTick_s) * kTick_s;
  const Pose2 rest = drive(FrontSteered{0.75}, {0.2 * time_s - arc_m, 30 * kDegree});
  EXPECT_THAT(
      drive_constantly(front_steered(), {.speed_mps = -0.2, .steering_rad = 30 * kDegree}, time_s) * rest,
      PoseNear(Pose2{-r, r, -kPi / 2}, 1e-9, 1e-9));
}

RC_GTEST_PROP(VehicleDynamics, ConstantControlsEndWhereTheClosedFormSays, (std::uint64_t seed)) {
  Random random(seed);
  const double steering_rad = random.uniform(-40, 40) * kDegree, speed_mps = random.uniform(-0.5, 1);
  const double turn_rate_rad_s = random.uniform(-90, 90) * kDegree;
  const double time_s = 0.01 * static_cast<double>(random.index(1000));
  const Pose2 steered =
      drive_constantly(front_steered(), {.speed_mps = speed_mps, .steering_rad = steering_rad}, time_s);
  RC_ASSERT(testing::Matches(PoseNear(
      drive(front_steered().front_steered, {speed_mps * time_s, steering_rad}), 1e-8, 1e-8))(steered));
  const Pose2 turned =
      drive_constantly(two_wheeled(), {.speed_mps = speed_mps, .turn_rate_rad_s = turn_rate_rad_s}, time_s);
  RC_ASSERT(testing::Matches(PoseNear(end_pose({speed_mps * time_s, turn_rate_rad_s * time_s}), 1e-8, 1e-8))(
      turned));
}

TEST(VehicleDynamics, ADifferentialVehicleTurnsOnTheSpot) {
  EXPECT_THAT(drive_constantly(two_wheeled(), {.turn_rate_rad_s = kPi / 4}, 2),
              PoseNear(Pose2{0, 0, kPi / 2}, 1e-12, 1e-9));
}

}  // namespace
}  // namespace aisle
