#include <gtest/gtest.h>

#include <cmath>

#include "aisle/simulation/vehicle/wheel_odometry.hpp"
#include "plain_vehicles.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

FrontSteeredMotion motion_of(WheelOdometry& odometry) {
  return std::get<FrontSteeredMotion>(odometry.read());
}

TEST(WheelOdometry, PerfectWheelsCountWhatIsDriven) {
  WheelOdometry odometry(front_steered(), kPerfectWheels, Random(1));
  for (int i = 0; i < 10; ++i) odometry.count({.distance_m = 0.003, .steering_rad = 0.2});
  const FrontSteeredMotion motion = motion_of(odometry);
  EXPECT_NEAR(motion.distance_m, 0.03, 1e-12);
  EXPECT_NEAR(motion.steering_rad, 0.2, 1e-12);
  EXPECT_EQ(motion_of(odometry).distance_m, 0);
}

TEST(WheelOdometry, TheSteeringIsAveragedOverTheDistance) {
  WheelOdometry odometry(front_steered(), kPerfectWheels, Random(1));
  odometry.count({.distance_m = 0.01, .steering_rad = 0});
  odometry.count({.distance_m = 0.03, .steering_rad = 0.4});
  EXPECT_NEAR(motion_of(odometry).steering_rad, 0.3, 1e-12);
  odometry.count({.distance_m = 0, .steering_rad = 0.1});
  EXPECT_NEAR(motion_of(odometry).steering_rad, 0.1, 1e-12);
}

TEST(WheelOdometry, EveryErrorByHand) {
  WheelErrors errors = kPerfectWheels;
  errors.distance_scale = 0.02;
  WheelOdometry scaled(front_steered(), errors, Random(1));
  scaled.count({.distance_m = 1});
  EXPECT_NEAR(motion_of(scaled).distance_m, 1.02, 1e-12);
  scaled.count({.distance_m = 1}, 0.5);
  EXPECT_NEAR(motion_of(scaled).distance_m, 1.53, 1e-12);

  errors = kPerfectWheels;
  errors.wheel_difference = 0.02;
  WheelOdometry uneven(two_wheeled(), errors, Random(1));
  uneven.count({.distance_m = 10});
  const auto steps = std::get<WheelSteps>(uneven.read());
  EXPECT_EQ(steps.left, std::lround(9.9 / Differential{}.step_length_m()));
  EXPECT_EQ(steps.right, std::lround(10.1 / Differential{}.step_length_m()));
}

TEST(WheelOdometry, RoundingLosesNothing) {
  WheelErrors errors = kPerfectWheels;
  errors.distance_quantum_m = 0.01;
  errors.steering_quantum_rad = 0.1;
  WheelOdometry odometry(front_steered(), errors, Random(1));
  double sum_m = 0;
  for (int i = 0; i < 1000; ++i) {
    odometry.count({.distance_m = 0.0033, .steering_rad = 0.17});
    const FrontSteeredMotion motion = motion_of(odometry);
    EXPECT_NEAR(motion.distance_m / 0.01, std::round(motion.distance_m / 0.01), 1e-6);
    EXPECT_NEAR(motion.steering_rad, 0.2, 1e-12);
    sum_m += motion.distance_m;
  }
  EXPECT_NEAR(sum_m, 3.3, 0.006);
}

TEST(WheelOdometry, StepsAddUpToTheDistanceOfTheWheels) {
  WheelOdometry odometry(two_wheeled(), kPerfectWheels, Random(1));
  Pose2 T_start_true, T_start_counted;
  for (int i = 0; i < 500; ++i) {
    const Travel travel{.distance_m = 0.01, .turn_rad = 0.005};
    odometry.count(travel);
    T_start_true = T_start_true * end_pose(arc_of(two_wheeled(), travel));
    T_start_counted = T_start_counted * drive(Differential{}, std::get<WheelSteps>(odometry.read()));
  }
  EXPECT_THAT(T_start_counted, PoseNear(T_start_true, 0.03, 0.01));
}

TEST(WheelOdometry, SlipSpreadsAsItSays) {
  WheelErrors errors = kPerfectWheels;
  errors.distance_slip_m_per_sqrt_m = 0.02;
  double squares_m2 = 0;
  constexpr int kRuns = 500;
  for (int run = 0; run < kRuns; ++run) {
    WheelOdometry odometry(front_steered(), errors, Random(static_cast<std::uint64_t>(run)));
    for (int i = 0; i < 100; ++i) odometry.count({.distance_m = 0.04});
    squares_m2 += std::pow(motion_of(odometry).distance_m - 4, 2) / kRuns;
  }
  EXPECT_NEAR(std::sqrt(squares_m2), 0.04, 0.004);
}

}  // namespace
}  // namespace aisle
