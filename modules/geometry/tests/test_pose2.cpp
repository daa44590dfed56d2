#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "aisle/core/random.hpp"
#include "aisle/geometry/pose2.hpp"
#include "aisle/geometry/pose_change.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

Pose2 any_pose(Random& random) {
  return {random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-kPi, kPi)};
}

TEST(Pose2, AVehicleAtOneOneFacingNorthSeesAheadToTheNorth) {
  const Pose2 T_map_vehicle{1, 1, kPi / 2};
  EXPECT_THAT((T_map_vehicle * Vec2(2, 0)), PointNear(Vec2(1, 3), 1e-12));
  EXPECT_THAT((T_map_vehicle * Vec2(0, 1)), PointNear(Vec2(0, 1), 1e-12));
}

RC_GTEST_PROP(Pose2, CompositionUndoesBetween, (std::uint64_t seed)) {
  Random random(seed);
  const Pose2 a = any_pose(random), b = any_pose(random);
  RC_ASSERT(testing::Matches(PoseNear(b, 1e-9, 1e-9))(a * between(a, b)));
  RC_ASSERT(testing::Matches(PoseNear(Pose2{}, 1e-9, 1e-9))(a * a.inverse()));
}

RC_GTEST_PROP(Pose2, ChangeBetweenMovesOneToTheOther, (std::uint64_t seed)) {
  Random random(seed);
  const Pose2 a = any_pose(random), b = any_pose(random);
  RC_ASSERT(testing::Matches(PoseNear(b, 1e-9, 1e-9))(moved_by(a, change_between(a, b))));
}

RC_GTEST_PROP(Pose2, CovariancePropagationMatchesNumericalJacobians, (std::uint64_t seed)) {
  Random random(seed);
  UncertainPose2 a{any_pose(random), Mat3::Random()}, b{any_pose(random), Mat3::Random()};
  a.covariance = (a.covariance * a.covariance.transpose()).eval();
  b.covariance = (b.covariance * b.covariance.transpose()).eval();
  const auto nudged = [](Pose2 pose, int axis, double step) {
    (axis == 0 ? pose.x : axis == 1 ? pose.y : pose.theta) += step;
    return pose;
  };
  const auto difference = [](const Pose2& plus, const Pose2& minus) {
    return Vec3(plus.x - minus.x, plus.y - minus.y, wrap_angle(plus.theta - minus.theta));
  };
  constexpr double kStep = 1e-6;
  Mat3 by_a, by_b, by_inverse;
  for (int i = 0; i < 3; ++i) {
    by_a.col(i) =
        difference(nudged(a.mean, i, kStep) * b.mean, nudged(a.mean, i, -kStep) * b.mean) / (2 * kStep);
    by_b.col(i) =
        difference(a.mean * nudged(b.mean, i, kStep), a.mean * nudged(b.mean, i, -kStep)) / (2 * kStep);
    by_inverse.col(i) =
        difference(nudged(a.mean, i, kStep).inverse(), nudged(a.mean, i, -kStep).inverse()) / (2 * kStep);
  }
  const Mat3 product = by_a * a.covariance * by_a.transpose() + by_b * b.covariance * by_b.transpose();
  RC_ASSERT(((a * b).covariance - product).norm() < 1e-5 * (1 + product.norm()));
  const Mat3 inverted = by_inverse * a.covariance * by_inverse.transpose();
  RC_ASSERT((inverse(a).covariance - inverted).norm() < 1e-5 * (1 + inverted.norm()));
}

TEST(Pose2, InterpolationTurnsTheShortWay) {
  const Pose2 half = interpolate({0, 0, 170 * kDegree}, {2, 0, -170 * kDegree}, 0.5);
  EXPECT_THAT(half, PoseNear(Pose2{1, 0, kPi}, 1e-12, 1e-12));
}

}  // namespace
}  // namespace aisle
