#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "aisle/core/random.hpp"
#include "aisle/vehicle/front_steered.hpp"
#include "numerical_jacobian.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

constexpr FrontSteeredNoise kPerfect{0, 0, 0, 0, 0, 0};

struct Case {
  FrontSteered vehicle;
  FrontSteeredMotion motion;
};

Case any_case(std::uint64_t seed) {
  Random random(seed);
  return {{random.uniform(0.2, 2)}, {random.uniform(-3, 3), random.uniform(-kPi / 2, kPi / 2)}};
}

/// A position in the papers' VCS (x right, y forward, origin between the front wheels) as one in base_link.
Vec2 from_vcs(const FrontSteered& vehicle, const Vec2& p_vcs) {
  return {p_vcs.y() + vehicle.wheelbase_m, -p_vcs.x()};
}

Vec2 rear_turning_centre(const FrontSteered& vehicle, double steering_rad) {
  return {0, vehicle.wheelbase_m / std::tan(steering_rad)};
}

TEST(FrontSteered, QuarterCircleByHand) {
  // Wheels at 45 degrees, 1 m before the rear axle: the rear turns about (0, 1) with 1 m, the front with
  // sqrt(2) m.
  const FrontSteered vehicle{1};
  const Pose2 T_start_end = drive(vehicle, {std::sqrt(2) * kPi / 2, 45 * kDegree});
  EXPECT_THAT(T_start_end, PoseNear(Pose2{1, 1, kPi / 2}, 1e-12, 1e-12));
  EXPECT_THAT(front_pose(vehicle, T_start_end), PoseNear(Pose2{1, 2, kPi / 2}, 1e-12, 1e-12));
}

TEST(FrontSteered, WithTheWheelsAcrossItTurnsOnTheSpotOfItsRearAxle) {
  const FrontSteered vehicle{0.5};
  EXPECT_THAT(drive(vehicle, {0.5 * kPi / 2, 90 * kDegree}), PoseNear(Pose2{0, 0, kPi / 2}, 1e-12, 1e-12));
  EXPECT_THAT(drive(vehicle, {0.5 * kPi / 2, -90 * kDegree}), PoseNear(Pose2{0, 0, -kPi / 2}, 1e-12, 1e-12));
}

TEST(FrontSteered, ReversingWithTheWheelsToTheLeftTurnsTheNoseToTheRight) {
  const Pose2 T_start_end = drive(FrontSteered{1}, {-0.5, 20 * kDegree});
  EXPECT_LT(T_start_end.x, 0);
  EXPECT_LT(T_start_end.theta, 0);
}

TEST(FrontSteered, DoesNotJumpAtSteeringZero) {
  const FrontSteered vehicle{0.5};
  EXPECT_THAT(drive(vehicle, {2, 0}), PoseNear(Pose2{2, 0, 0}, 0, 0));
  EXPECT_THAT(drive(vehicle, {2, 1e-12}), PoseNear(drive(vehicle, {2, 0}), 1e-11, 1e-11));
  EXPECT_THAT(drive(vehicle, {2, -1e-12}), PoseNear(drive(vehicle, {2, 0}), 1e-11, 1e-11));
  EXPECT_LT((drive_jacobian(vehicle, {2, 1e-12}) - drive_jacobian(vehicle, {2, 0})).norm(), 1e-10);
}

TEST(FrontSteered, FollowsItsSeriesForSmallSteering) {
  const FrontSteered vehicle{0.5};
  const double distance = 2, steering = 1e-4, turn = distance * steering / vehicle.wheelbase_m;
  const Pose2 series{distance * (1 - turn * turn / 6 - steering * steering / 2), distance * turn / 2, turn};
  EXPECT_THAT(drive(vehicle, {distance, steering}), PoseNear(series, 1e-10, 1e-10));
}

RC_GTEST_PROP(FrontSteered, AgreesWithThePapersFormulasOnceTheMisprintIsMended, (std::uint64_t seed)) {
  const auto [vehicle, motion] = any_case(seed);
  const double d = vehicle.wheelbase_m, S = motion.distance_m;
  const double delta = -motion.steering_rad;                       // the papers steer to the right
  const double R = d / std::sin(delta);                            // C99 eq. (1)
  const double gamma = S / R;                                      // eq. (2)
  const double chord = 2 * R * std::sin(gamma / 2);                // eq. (3), with its sign
  const double u = kPi / 2 - delta - gamma / 2;                    // eq. (4)
  const Vec2 front_vcs{chord * std::cos(u), chord * std::sin(u)};  // eq. (5)
  const Vec2 back_vcs = front_vcs - d * Vec2(std::sin(gamma), std::cos(gamma));  // eq. (6), mended
  const Pose2 T_start_end = drive(vehicle, motion);
  RC_ASSERT((front_pose(vehicle, T_start_end).position() - from_vcs(vehicle, front_vcs)).norm() < 1e-9);
  RC_ASSERT(std::abs((T_start_end.position() - from_vcs(vehicle, front_vcs)).norm() - d) < 1e-9);
  RC_ASSERT((T_start_end.position() - from_vcs(vehicle, back_vcs)).norm() < 1e-9);
  RC_ASSERT(std::abs(wrap_angle(T_start_end.theta + gamma)) < 1e-9);
}

TEST(FrontSteered, AsPrintedTheRearWouldLeaveItsCircle) {
  // d = 1, 45 degrees to the right, a quarter circle: in the VCS at the start the front goes from (0, 0) to
  // (2, 0) about (1, -1), and the rear from (0, -1), 1 m from there.
  const double gamma = kPi / 2;
  const Vec2 centre_vcs{1, -1}, front_vcs{2, 0};
  const Vec2 mended_vcs = front_vcs - Vec2(std::sin(gamma), std::cos(gamma));
  const Vec2 printed_vcs = front_vcs + Vec2(std::sin(gamma), -std::cos(gamma));
  EXPECT_NEAR((mended_vcs - centre_vcs).norm(), 1, 1e-12);
  EXPECT_NEAR((printed_vcs - centre_vcs).norm(), std::sqrt(5), 1e-12);
  EXPECT_THAT(drive(FrontSteered{1}, {std::sqrt(2) * gamma, -45 * kDegree}).position(),
              PointNear(from_vcs({1}, mended_vcs), 1e-12));
}

RC_GTEST_PROP(FrontSteered, TheRearKeepsItsDistanceFromTheTurningCentre, (std::uint64_t seed)) {
  const auto [vehicle, motion] = any_case(seed);
  RC_PRE(std::abs(motion.steering_rad) > 1e-3);
  const Vec2 centre = rear_turning_centre(vehicle, motion.steering_rad);
  const Pose2 T_start_end = drive(vehicle, motion);
  RC_ASSERT(std::abs((T_start_end.position() - centre).norm() - centre.norm()) < 1e-9);
  RC_ASSERT((T_start_end * centre - centre).norm() < 1e-9);
}

RC_GTEST_PROP(FrontSteered, TheFrontRollsAlongTheReportedDistance, (std::uint64_t seed)) {
  const auto [vehicle, motion] = any_case(seed);
  RC_PRE(std::abs(motion.steering_rad) > 1e-3);
  const Vec2 centre = rear_turning_centre(vehicle, motion.steering_rad);
  const Vec2 front = front_pose(vehicle, {}).position();
  const double turn = arc_of(vehicle, motion).turn_rad;
  RC_ASSERT(std::abs((front - centre).norm() * std::abs(turn) - std::abs(motion.distance_m)) < 1e-9);
}

RC_GTEST_PROP(FrontSteered, DrivingBackWithTheSameSteeringReturns, (std::uint64_t seed)) {
  const auto [vehicle, motion] = any_case(seed);
  const Pose2 T_start_end =
      drive(vehicle, motion) * drive(vehicle, {-motion.distance_m, motion.steering_rad});
  RC_ASSERT(testing::Matches(PoseNear(Pose2{}, 1e-9, 1e-9))(T_start_end));
}

RC_GTEST_PROP(FrontSteered, ManySmallMotionsAreOneLargeOne, (std::uint64_t seed)) {
  const auto [vehicle, motion] = any_case(seed);
  constexpr int kParts = 50;
  Pose2 T_start_end;
  for (int i = 0; i < kParts; ++i) {
    T_start_end = T_start_end * drive(vehicle, {motion.distance_m / kParts, motion.steering_rad});
  }
  RC_ASSERT(testing::Matches(PoseNear(drive(vehicle, motion), 1e-9, 1e-9))(T_start_end));
}

RC_GTEST_PROP(FrontSteered, JacobianMatchesNumericalDifferences, (std::uint64_t seed)) {
  const auto [drawn, motion] = any_case(seed);
  const FrontSteered vehicle = drawn;
  const Mat32 numerical = numerical_jacobian(
      [&](const Vec2& m) {
        return drive(vehicle, {m.x(), m.y()});
      },
      {motion.distance_m, motion.steering_rad});
  RC_ASSERT((drive_jacobian(vehicle, motion) - numerical).norm() < 1e-6 * (1 + numerical.norm()));
}

TEST(FrontSteered, StandingStillAddsNoUncertainty) {
  EXPECT_TRUE(drive({0.5}, {0, 0.3}, FrontSteeredNoise{}).covariance.isZero());
}

TEST(FrontSteered, EverySourceOfNoiseByHand) {
  const FrontSteered vehicle{0.5};
  const FrontSteeredMotion ahead{4, 0};
  FrontSteeredNoise noise = kPerfect;
  EXPECT_TRUE(drive(vehicle, ahead, noise).covariance.isZero());
  noise.distance_scale = 0.01;  // 4 cm of 4 m
  EXPECT_NEAR(std::sqrt(drive(vehicle, ahead, noise).covariance(0, 0)), 0.04, 1e-12);
  noise = kPerfect;
  noise.distance_slip_m_per_sqrt_m = 0.01;  // twice that after 4 m
  EXPECT_NEAR(std::sqrt(drive(vehicle, ahead, noise).covariance(0, 0)), 0.02, 1e-12);
  noise = kPerfect;
  noise.distance_quantum_m = 0.006;  // half of it at most, at either end: variance 36e-6 / 12 twice
  EXPECT_NEAR(drive(vehicle, ahead, noise).covariance(0, 0), 6e-6, 1e-15);
  noise = kPerfect;
  noise.heading_slip_rad_per_sqrt_m = 0.01;
  EXPECT_NEAR(std::sqrt(drive(vehicle, ahead, noise).covariance(2, 2)), 0.02, 1e-12);
  noise = kPerfect;
  noise.steering_bias_rad = 0.01;  // 4 m / 0.5 m * 0.01; the rear drifts by half the distance times the turn
  EXPECT_NEAR(std::sqrt(drive(vehicle, ahead, noise).covariance(2, 2)), 0.08, 1e-12);
  EXPECT_NEAR(std::sqrt(drive(vehicle, ahead, noise).covariance(1, 1)), 0.16, 1e-12);
  noise = kPerfect;
  noise.steering_quantum_rad = 0.01 * std::sqrt(12);
  EXPECT_NEAR(std::sqrt(drive(vehicle, ahead, noise).covariance(2, 2)), 0.08, 1e-12);
}

TEST(FrontSteered, CovarianceMatchesASeededMonteCarlo) {
  const FrontSteered vehicle{0.5};
  const FrontSteeredMotion motion{1, 25 * kDegree};
  FrontSteeredNoise noise = kPerfect;
  noise.distance_scale = 0.02;
  noise.steering_bias_rad = 1 * kDegree;
  const UncertainPose2 predicted = drive(vehicle, motion, noise);
  Random random(3);
  Mat3 sampled = Mat3::Zero();
  constexpr int kDraws = 20000;
  for (int i = 0; i < kDraws; ++i) {
    const Pose2 drawn = drive(vehicle, {motion.distance_m * (1 + random.normal(noise.distance_scale)),
                                        motion.steering_rad + random.normal(noise.steering_bias_rad)});
    const Vec3 off(drawn.x - predicted.mean.x, drawn.y - predicted.mean.y,
                   drawn.theta - predicted.mean.theta);
    sampled += off * off.transpose() / kDraws;
  }
  EXPECT_LT((sampled - predicted.covariance).norm(), 0.03 * predicted.covariance.norm());
}

}  // namespace
}  // namespace aisle
