#include "aisle/learning/walls/odometry_scale.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Cholesky>
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

/// The pose's covariance after a step that is known exactly.
Mat3 carried_on(const Mat3& covariance, const Pose2& from, const Pose2& step) {
  const Vec2 moved = rotate(from.theta, step.position());
  Mat3 by_pose = Mat3::Identity();
  by_pose(0, 2) = -moved.y();
  by_pose(1, 2) = moved.x();
  return by_pose * covariance * by_pose.transpose();
}

RC_GTEST_PROP(OdometryScale, IsTheFourthUnknownOfOneKalmanFilter, (std::uint64_t seed)) {
  constexpr double kTurn_rad2 = 1e-4;
  constexpr double kCorrection = 0.002;  // [m, rad] so small that the factor stays realistic
  Random random(seed);
  OdometryScale scale(0.05);
  WholeFilter whole;
  whole.covariance = Vec4(0.01, 0.02, 0.001, square(0.05)).asDiagonal();
  Mat3 covariance = whole.covariance.topLeftCorner<3, 3>();
  for (int i = 0; i < 20; ++i) {
    const Pose2 counted{random.uniform(-0.5, 0.5), random.uniform(-0.1, 0.1), random.uniform(-0.3, 0.3)};
    const Pose2 step = scale.true_step(counted);
    const Pose2 from{whole.state(0), whole.state(1), whole.state(2)};
    covariance = carried_on(covariance, from, step);
    covariance(2, 2) += kTurn_rad2;
    scale.predict(from, step, covariance);
    whole.predict(step, kTurn_rad2);

    const Vec3 correction(random.uniform(-kCorrection, kCorrection),
                          random.uniform(-kCorrection, kCorrection),
                          random.uniform(-kCorrection, kCorrection));
    const Mat3 information = any_information(random);
    const Mat3 posterior = (covariance.inverse() + information).inverse();
    scale.correct(covariance, correction, posterior);
    covariance = posterior;
    whole.correct(correction, information);
    RC_ASSERT(std::abs(scale.factor() - whole.state(3)) < 1e-7);
    RC_ASSERT((covariance - whole.covariance.topLeftCorner<3, 3>()).norm() < 1e-7);
  }
}

TEST(OdometryScale, StaysOneIfItIsKnownToBeOne) {
  OdometryScale scale(0);
  const Mat3 before = 0.01 * Mat3::Identity();
  Mat3 covariance = before;
  scale.predict({0, 0, 1}, {2, 0, 0}, covariance);
  EXPECT_EQ(covariance, before);
  scale.correct(covariance, {0.1, 0.2, 0}, 0.5 * covariance);
  EXPECT_EQ(scale.factor(), 1);
}

TEST(OdometryScale, APoseKnownFromElsewhereDoesNotChangeIt) {
  OdometryScale scale(0.05);
  Mat3 covariance = 0.001 * Mat3::Identity();
  scale.predict({}, {3, 0, 0}, covariance);
  scale.forget_pose();
  scale.correct(covariance, {0.1, 0, 0}, 0.5 * covariance);
  EXPECT_EQ(scale.factor(), 1);
}

TEST(OdometryScale, CorrectsEarlierPositionsByAFactorLearnedLater) {
  OdometryScale scale(0.02);
  Mat3 covariance = 1e-6 * Mat3::Identity();
  scale.predict({}, {10, 0, 0}, covariance);
  EXPECT_NEAR(scale.path().off_m(1.01).x(), 0.1, 1e-9);
  EXPECT_NEAR(scale.path().off_m(1).norm(), 0, 1e-9);
}

TEST(OdometryScale, SeeingAWallAgainSaysNothingOfThePathThere) {
  OdometryScale scale(0.02);
  Mat3 covariance = 1e-6 * Mat3::Identity();
  scale.predict({}, {10, 0, 0}, covariance);
  const CountedPath first_seen = scale.path();
  EXPECT_EQ(scale.refer_to(first_seen, covariance), Vec2(0, 0));
  const Mat3 seen = covariance;
  scale.correct(seen, Vec3::Zero(), 0.5 * seen);  // where it was
  EXPECT_NEAR(scale.path().off_m(1.01).x(), 0.1, 1e-4);

  scale.predict({10, 0, 0}, {1, 0, 0}, covariance);
  scale.correct(covariance, {0.01, 0, 0}, 1e-9 * Mat3::Identity());
  EXPECT_NEAR(scale.factor(), 1.01, 1e-3);  // 1 cm in 1 m, not in 11 m
  EXPECT_NEAR(scale.path().off_m(1.01).x(), 0.1, 0.01);
}

TEST(OdometryScale, WallsSeenOnTheWayOutSayNothingOnTheWayBack) {
  OdometryScale scale(0.02);
  Mat3 covariance = 1e-6 * Mat3::Identity();
  scale.predict({}, {4, 0, 0}, covariance);
  const CountedPath to_mark = scale.path();
  scale.predict({4, 0, 0}, {6, 0, 0}, covariance);
  scale.predict({10, 0, kPi}, {6, 0, 0}, covariance);
  EXPECT_NEAR(scale.refer_to(to_mark, covariance).norm(), 0, 1e-12);
  EXPECT_NEAR(covariance(0, 0), 1e-6, 1e-9) << "both were counted by the same factor";
  scale.correct(covariance, {0.05, 0, 0}, 1e-9 * Mat3::Identity());
  EXPECT_NEAR(scale.factor(), 1, 1e-9);
}

TEST(OdometryScale, KnowsThatItComesBackToAnotherPlaceThanTheTrackedStart) {
  OdometryScale scale(0.02);
  Mat3 covariance = 1e-6 * Mat3::Identity();
  const CountedPath to_start = scale.path();
  scale.predict({}, {10, 0, 0}, covariance);
  scale.refer_to(scale.path(), covariance);  // to what it sees first there; then it learns the factor by it
  scale.predict({10, 0, 0}, {1, 0, 0}, covariance);
  const Mat3 prior = covariance;
  covariance = 1e-9 * Mat3::Identity();
  scale.correct(prior, {0.01, 0, 0}, covariance);
  ASSERT_NEAR(scale.factor(), 1.01, 1e-4);
  scale.predict({11.01, 0, kPi}, scale.true_step({11, 0, 0}), covariance);  // to -0.1 m, as laid
  EXPECT_NEAR(scale.refer_to(to_start, covariance).x(), 0.1, 2e-3);
}

RC_GTEST_PROP(OdometryScale, WhatThePoseRefersToChangesNothingThatIsKnown, (std::uint64_t seed)) {
  Random random(seed);
  OdometryScale scale(0.02);
  Mat3 covariance = 0.01 * Mat3::Identity();
  for (int i = 0; i < 5; ++i) {
    const Pose2 from{0, 0, random.uniform(-3, 3)};
    const Pose2 step{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    covariance = carried_on(covariance, from, step);
    scale.predict(from, step, covariance);
    const Mat3 prior = covariance;
    covariance = (covariance.inverse() + any_information(random)).inverse();
    scale.correct(prior, Vec3::Constant(random.uniform(-0.01, 0.01)), covariance);
  }
  const CountedPath there = scale.path();
  const CountedPath elsewhere{{random.uniform(-9, 9), random.uniform(-9, 9)},
                              {random.uniform(-9, 9), random.uniform(-9, 9)}};
  const Vec2 moved = scale.refer_to(elsewhere, covariance);
  const Vec2 off_before = there.off_m(scale.factor()), off = scale.path().off_m(scale.factor());
  RC_ASSERT((off + moved - off_before).norm() < 1e-9);
  RC_ASSERT((scale.path().by_factor - there.by_factor).norm() < 1e-9);
  RC_ASSERT(covariance.ldlt().isPositive());
}

}  // namespace
}  // namespace aisle
