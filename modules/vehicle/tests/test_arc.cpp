#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "aisle/core/angle.hpp"
#include "aisle/core/random.hpp"
#include "aisle/vehicle/arc.hpp"
#include "numerical_jacobian.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

TEST(Arc, QuarterCirclesByHand) {
  EXPECT_THAT(end_pose({kPi, kPi / 2}), PoseNear(Pose2{2, 2, kPi / 2}, 1e-12, 1e-12));
  EXPECT_THAT(end_pose({kPi, -kPi / 2}), PoseNear(Pose2{2, -2, -kPi / 2}, 1e-12, 1e-12));
  EXPECT_THAT(end_pose({-kPi, kPi / 2}), PoseNear(Pose2{-2, -2, kPi / 2}, 1e-12, 1e-12));
}

TEST(Arc, AFullCircleComesBack) {
  EXPECT_THAT(end_pose({3, 2 * kPi}), PoseNear(Pose2{}, 1e-12, 1e-12));
}

TEST(Arc, StraightOnAndOnTheSpotAreArcsToo) {
  EXPECT_THAT(end_pose({3, 0}), PoseNear(Pose2{3, 0, 0}, 0, 0));
  EXPECT_THAT(end_pose({0, 1}), PoseNear(Pose2{0, 0, 1}, 0, 0));
}

TEST(Arc, DoesNotJumpAtTurnZero) {
  EXPECT_THAT(end_pose({3, 1e-12}), PoseNear(end_pose({3, 0}), 1e-11, 1e-11));
  EXPECT_THAT(end_pose({3, -1e-12}), PoseNear(end_pose({3, 0}), 1e-11, 1e-11));
  EXPECT_LT((end_pose_jacobian({3, 1e-12}) - end_pose_jacobian({3, 0})).norm(), 1e-11);
}

TEST(Arc, FollowsItsSeriesForSmallTurns) {
  const double g = 1e-4;
  const Pose2 series{3 * (1 - g * g / 6), 3 * (g / 2 - g * g * g / 24), g};
  EXPECT_THAT(end_pose({3, g}), PoseNear(series, 1e-15, 1e-18));
}

TEST(Arc, JacobianDoesNotJumpWhereItsSeriesEnds) {
  const double half_turn = 1e-2;  // the two forms meet here
  EXPECT_LT((end_pose_jacobian({3, 2 * half_turn * (1 - 1e-12)}) -
             end_pose_jacobian({3, 2 * half_turn * (1 + 1e-12)}))
                .norm(),
            1e-10);
}

RC_GTEST_PROP(Arc, JacobianMatchesNumericalDifferences, (std::uint64_t seed)) {
  Random random(seed);
  const Vec2 arc{random.uniform(-5, 5), random.uniform(-4, 4) * std::pow(10, -random.uniform(0, 6))};
  const Mat32 numerical = numerical_jacobian([](const Vec2& a) { return end_pose({a.x(), a.y()}); }, arc);
  RC_ASSERT((end_pose_jacobian({arc.x(), arc.y()}) - numerical).norm() < 1e-7);
}

}  // namespace
}  // namespace aisle
