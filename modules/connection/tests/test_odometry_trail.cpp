#include <gtest/gtest.h>

#include "odometry_trail.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

using Taken = OdometryTrail::Taken;

TEST(OdometryTrail, IsTheMotionSinceItsFirstSample) {
  OdometryTrail trail(0.2, 1);
  EXPECT_EQ(trail.take(10, {5, 3, kPi / 2}), Taken::kMotion);
  EXPECT_EQ(trail.take(10.1, {5, 3.1, kPi / 2}), Taken::kMotion);
  EXPECT_THAT(trail.at(10.1), PoseNear(Pose2{0.1, 0, 0}, 1e-9, 1e-9));
  EXPECT_THAT(trail.at(10.05), PoseNear(Pose2{0.05, 0, 0}, 1e-9, 1e-9));
}

TEST(OdometryTrail, LeavesALeapOutAndGoesOnFromThere) {
  OdometryTrail trail(0.2, 1);
  trail.take(0, {0, 0, 0});
  trail.take(0.1, {0.05, 0, 0});
  EXPECT_EQ(trail.take(0.2, {7, 4, 1}), Taken::kLeap);
  EXPECT_THAT(trail.at(0.2), PoseNear(Pose2{0.05, 0, 0}, 1e-9, 1e-9));
  trail.take(0.3, Pose2{7, 4, 1} * Pose2{0.1, 0, 0.1});
  EXPECT_THAT(trail.at(0.3), PoseNear(Pose2{0.05, 0, 0} * Pose2{0.1, 0, 0.1}, 1e-9, 1e-9));
}

TEST(OdometryTrail, KnowsARestartByItsReturnToTheOrigin) {
  OdometryTrail trail(0.2, 1);
  trail.take(0, {4, 1, 0});
  trail.take(0.1, {4.05, 1, 0});
  EXPECT_EQ(trail.take(0.2, {0.01, 0, 0}), Taken::kRestart);
}

TEST(OdometryTrail, DrivingThroughTheOriginIsNoRestart) {
  OdometryTrail trail(0.2, 1);
  trail.take(0, {-0.1, 0, 0});
  EXPECT_EQ(trail.take(0.1, {0, 0, 0}), Taken::kMotion);
}

TEST(OdometryTrail, TakesNothingThatIsNotNewer) {
  OdometryTrail trail(0.2, 1);
  trail.take(5, {0, 0, 0});
  trail.take(5.1, {0.1, 0, 0});
  EXPECT_EQ(trail.take(5.1, {0.3, 0, 0}), Taken::kOutOfOrder);
  EXPECT_EQ(trail.take(4, {0.2, 0, 0}), Taken::kOutOfOrder);
  EXPECT_THAT(trail.at(5.1), PoseNear(Pose2{0.1, 0, 0}, 1e-9, 1e-9));
}

TEST(OdometryTrail, AllowsAGapTheWayThatItsSpeedAllows) {
  OdometryTrail trail(0.2, 1);
  trail.take(0, {0, 0, 0});
  EXPECT_EQ(trail.take(0.5, {0.9, 0, 0}), Taken::kMotion);
  EXPECT_EQ(trail.take(60, {4, 0, 0}), Taken::kLeap) << "a long gap does not allow any leap";
}

}  // namespace
}  // namespace aisle
