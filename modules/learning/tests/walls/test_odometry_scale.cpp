#include "aisle/learning/walls/odometry_scale.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "aisle/core/random.hpp"
#include "aisle/core/square.hpp"

namespace aisle {
namespace {

using Mat4 = Eigen::Matrix4d;
using Vec4 = Eigen::Vector4d;

/// A Kalman filter of (x, y, theta, factor), written out.
struct WholeFilter {
  Vec4 state{0, 0, 0, 1};
  Mat4 covariance = Mat4::Zero();

  void predict(const Pose2& step, double turn_rad2) {
    const Vec2 moved = rotate(state(2), step.position());
    Mat4 by_state = Mat4::Identity();
    by_state(0, 2) = -moved.y();
    by_state(1, 2) = moved.x();
    by_state(0, 3) = moved.x() / state(3);
    by_state(1, 3) = moved.y() / state(3);
    covariance = by_state * covariance * by_state.transpose();
    covariance(2, 2) += turn_rad2;
    state.head<2>() += moved;
    state(2) += step.theta;
  }

  void correct(const Vec3& correction, const Mat3& information) {
    Mat4 whole = Mat4::Zero();
    whole.topLeftCorner<3, 3>() = information;
    const Mat4 after = (covariance.inverse() + whole).inverse();
    // A measurement that moves the pose by `correction`: it says pose + (1 + (P W)^-1) correction.
    const Mat3 prior = covariance.topLeftCorner<3, 3>();
    const Vec3 says = correction + (prior * information).inverse() * correction;
    Vec4 pulled = Vec4::Zero();
    pulled.head<3>() = information * says;
    state += after * pulled;
    covariance = after;
  }
};

Mat3 any_information(Random& random) {
  Mat3 roots;
  for (int i = 0; i < 9; ++i) roots(i / 3, i % 3) = random.uniform(-30, 30);
  return roots * roots.transpose() + 10 * Mat3::Identity();
}

RC_GTEST_PROP(OdometryScale, IsTheFourthUnknownOfOneKalmanFilter, (std::uint64_t seed)) {
  constexpr double kTurn_rad2 = 1e-4;
  Random random(seed);
  OdometryScale scale(0.05);
  WholeFilter whole;
  whole.covariance = Vec4(0.01, 0.02, 0.001, square(0.05)).asDiagonal();
  Mat3 covariance = whole.covariance.topLeftCorner<3, 3>();
  for (int i = 0; i < 20; ++i) {
    const Pose2 counted{random.uniform(-0.5, 0.5), random.uniform(-0.1, 0.1), random.uniform(-0.3, 0.3)};
    const Pose2 step = scale.true_step(counted);
    const Pose2 from{whole.state(0), whole.state(1), whole.state(2)};
    const Vec2 moved = rotate(from.theta, step.position());
    Mat3 by_pose = Mat3::Identity();
    by_pose(0, 2) = -moved.y();
    by_pose(1, 2) = moved.x();
    covariance = by_pose * covariance * by_pose.transpose();
    covariance(2, 2) += kTurn_rad2;
    scale.predict(from, step, covariance);
    whole.predict(step, kTurn_rad2);

    const Vec3 correction(random.uniform(-0.01, 0.01), random.uniform(-0.01, 0.01),
                          random.uniform(-0.01, 0.01));
    const Mat3 information = any_information(random);
    const Mat3 posterior = (covariance.inverse() + information).inverse();
    scale.correct(covariance, correction, posterior);
    covariance = posterior;
    whole.correct(correction, information);
    RC_ASSERT(std::abs(scale.factor() - whole.state(3)) < 1e-7);
    RC_ASSERT((covariance - whole.covariance.topLeftCorner<3, 3>()).norm() < 1e-7);
  }
}

TEST(OdometryScale, StaysOneWhereItIsKnownToBe) {
  OdometryScale scale(0);
  const Mat3 before = 0.01 * Mat3::Identity();
  Mat3 covariance = before;
  scale.predict({0, 0, 1}, {2, 0, 0}, covariance);
  EXPECT_EQ(covariance, before);
  scale.correct(covariance, {0.1, 0.2, 0}, 0.5 * covariance);
  EXPECT_EQ(scale.factor(), 1);
}

TEST(OdometryScale, APoseThatIsKnownAnewSaysNothingOfIt) {
  OdometryScale scale(0.05);
  Mat3 covariance = 0.001 * Mat3::Identity();
  scale.predict({}, {3, 0, 0}, covariance);
  scale.forget_pose();
  scale.correct(covariance, {0.1, 0, 0}, 0.5 * covariance);
  EXPECT_EQ(scale.factor(), 1);
}

TEST(OdometryScale, TellsHowFarAPlaceIsByAFactorThatIsLearnedLater) {
  OdometryScale scale(0.02);
  Mat3 covariance = 1e-6 * Mat3::Identity();
  scale.predict({}, {10, 0, 0}, covariance);
  EXPECT_NEAR(scale.way().off_m(1.01).x(), 0.1, 1e-9);
  EXPECT_NEAR(scale.way().off_m(1).norm(), 0, 1e-9);
}

TEST(OdometryScale, WhatIsSeenFirstAndThenAgainSaysNothingOfTheWayThere) {
  OdometryScale scale(0.02);
  Mat3 covariance = 1e-6 * Mat3::Identity();
  scale.predict({}, {10, 0, 0}, covariance);
  const Mat3 seen = 1e-6 * Mat3::Identity();
  scale.count_from_here(covariance, seen);
  scale.correct(seen, Vec3::Zero(), 0.5 * seen);  // where it was
  EXPECT_NEAR(scale.way().off_m(1.01).x(), 0.1, 1e-4);

  covariance = seen;
  scale.predict({10, 0, 0}, {1, 0, 0}, covariance);
  scale.correct(covariance, {0.01, 0, 0}, 1e-9 * Mat3::Identity());
  EXPECT_NEAR(scale.factor(), 1.01, 1e-3);  // 1 cm in 1 m, not in 11 m
  EXPECT_NEAR(scale.way().off_m(1.01).x(), 0.1, 0.01);
}

}  // namespace
}  // namespace aisle
