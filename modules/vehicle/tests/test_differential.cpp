#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "aisle/core/random.hpp"
#include "aisle/vehicle/differential.hpp"
#include "numerical_jacobian.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

constexpr DifferentialNoise kNoNoise{0, 0, 0};

WheelSteps any_steps(std::uint64_t seed) {
  Random random(seed);
  const auto any = [&] { return static_cast<int>(random.index(1001)) - 500; };
  return {any(), any()};
}

TEST(Differential, AFullTurnOfBothWheelsGoesOneCircumferenceAhead) {
  EXPECT_THAT(drive(Differential{}, {200, 200}), PoseNear(Pose2{2 * kPi * 0.043, 0, 0}, 1e-12, 0));
}

TEST(Differential, QuarterCircleAboutTheLeftWheelByHand) {
  Differential vehicle;
  vehicle.wheel_separation_m = 0.172;  // 4 wheel radii: a full turn of the right wheel is a quarter circle
  const Pose2 T_start_end = drive(vehicle, {0, 200});
  EXPECT_THAT(T_start_end, PoseNear(Pose2{0.086, 0.086, kPi / 2}, 1e-12, 1e-12));
  EXPECT_THAT((T_start_end * Vec2(0, 0.086)), PointNear(Vec2(0, 0.086), 1e-12));
}

TEST(Differential, OpposedWheelsTurnOnTheSpot) {
  const Pose2 T_start_end = drive(Differential{}, {-40, 40});
  EXPECT_THAT(T_start_end, PoseNear(Pose2{0, 0, 80 * 2 * kPi * 0.043 / 200 / 0.186}, 1e-15, 1e-12));
}

TEST(Differential, ATurnQuantumOfTheMiniVehicleIsThreeSteps) {
  // 2.5 degrees on a circle of 9.3 cm are 4.06 mm, a step is 1.35 mm.
  const WheelSteps left = turn_on_the_spot(Differential{}, 1), right = turn_on_the_spot(Differential{}, -1);
  EXPECT_EQ(left.left, -3);
  EXPECT_EQ(left.right, 3);
  EXPECT_EQ(right.left, 3);
  EXPECT_EQ(right.right, -3);
}

TEST(Differential, ARightAngleOfQuantaIsOffByLessThanAStep) {
  const Differential vehicle;
  const double turned = drive(vehicle, turn_on_the_spot(vehicle, 36)).theta;
  EXPECT_NEAR(turned, kPi / 2, vehicle.step_length_m() / vehicle.wheel_separation_m);
}

TEST(Differential, DoesNotJumpWhereTheWheelsAreEqual) {
  Differential vehicle;
  vehicle.steps_per_turn = 1'000'000'000;  // so that one step more is next to nothing
  EXPECT_THAT(drive(vehicle, {1'000'000'000, 1'000'000'001}),
              PoseNear(drive(vehicle, {1'000'000'000, 1'000'000'000}), 1e-8, 1e-8));
}

RC_GTEST_PROP(Differential, TheWheelsRollAlongCirclesAboutOneCentre, (std::uint64_t seed)) {
  const Differential vehicle;
  const WheelSteps steps = any_steps(seed);
  RC_PRE(steps.left != steps.right);
  const Arc arc = arc_of(vehicle, steps);
  const Vec2 centre{0, arc.length_m / arc.turn_rad};
  RC_ASSERT((drive(vehicle, steps) * centre - centre).norm() < 1e-9);
  const double half_m = vehicle.wheel_separation_m / 2;
  RC_ASSERT(std::abs((centre.y() - half_m) * arc.turn_rad - steps.left * vehicle.step_length_m()) < 1e-9);
  RC_ASSERT(std::abs((centre.y() + half_m) * arc.turn_rad - steps.right * vehicle.step_length_m()) < 1e-9);
}

RC_GTEST_PROP(Differential, SteppingBackReturns, (std::uint64_t seed)) {
  const Differential vehicle;
  const WheelSteps steps = any_steps(seed);
  const Pose2 T_start_end = drive(vehicle, steps) * drive(vehicle, {-steps.left, -steps.right});
  RC_ASSERT(testing::Matches(PoseNear(Pose2{}, 1e-9, 1e-9))(T_start_end));
}

RC_GTEST_PROP(Differential, ManySmallMotionsAreOneLargeOne, (std::uint64_t seed)) {
  const Differential vehicle;
  const WheelSteps steps = any_steps(seed);
  Pose2 T_start_end;
  for (int i = 0; i < 20; ++i) T_start_end = T_start_end * drive(vehicle, steps);
  RC_ASSERT(testing::Matches(PoseNear(drive(vehicle, {20 * steps.left, 20 * steps.right}), 1e-9, 1e-9))(
      T_start_end));
}

RC_GTEST_PROP(Differential, JacobianMatchesNumericalDifferences, (std::uint64_t seed)) {
  const Differential vehicle;
  const WheelSteps steps = any_steps(seed);
  const auto pose_of_distances = [&](const Vec2& distances_m) {
    return end_pose(
        {distances_m.sum() / 2, (distances_m.y() - distances_m.x()) / vehicle.wheel_separation_m});
  };
  const Mat32 numerical =
      numerical_jacobian(pose_of_distances, Vec2(steps.left, steps.right) * vehicle.step_length_m());
  RC_ASSERT((drive_jacobian(vehicle, steps) - numerical).norm() < 1e-6 * (1 + numerical.norm()));
}

TEST(Differential, StandingStillAddsNoUncertainty) {
  EXPECT_TRUE(drive(Differential{}, {0, 0}, DifferentialNoise{}).covariance.isZero());
}

TEST(Differential, EverySourceOfNoiseByHand) {
  Differential vehicle;
  vehicle.wheel_radius_m = 1 / (2 * kPi);  // a turn is a metre
  vehicle.wheel_separation_m = 0.2;
  const double rounding_m2 = 0.005 * 0.005 / 6;
  const WheelSteps ahead{800, 800}, about{-20, 20};
  DifferentialNoise noise = kNoNoise;
  EXPECT_NEAR(drive(vehicle, ahead, noise).covariance(0, 0), rounding_m2 / 2, 1e-15);
  noise.wheel_scale = 0.01;  // 4 cm a wheel: 4 cm / sqrt(2) in the middle, 4 cm * sqrt(2) / 20 cm in heading
  EXPECT_NEAR(drive(vehicle, ahead, noise).covariance(0, 0), (0.04 * 0.04 + rounding_m2) / 2, 1e-12);
  EXPECT_NEAR(drive(vehicle, ahead, noise).covariance(2, 2), (0.04 * 0.04 + rounding_m2) * 2 / 0.04, 1e-12);
  noise = kNoNoise;
  noise.wheel_slip_m_per_sqrt_m = 0.01;  // twice that after 4 m
  EXPECT_NEAR(drive(vehicle, ahead, noise).covariance(0, 0), (0.02 * 0.02 + rounding_m2) / 2, 1e-12);
  noise = kNoNoise;
  noise.separation_scale = 0.01;  // of a turn by 1 rad
  EXPECT_NEAR(drive(vehicle, about, noise).covariance(2, 2), 0.01 * 0.01 + rounding_m2 * 2 / 0.04, 1e-12);
}

}  // namespace
}  // namespace aisle
