#include "aisle/learning/walls/scan_odometry.hpp"

#include <gmock/gmock.h>

#include "pose_matchers.hpp"
#include "walls/recorded_drive.hpp"

namespace aisle {
namespace {

constexpr double kScan_s = 0.1;

/// The laser's poses in the frame of the first by scans along a path.
std::vector<Pose2> followed(const std::vector<Segment2>& walls, const std::vector<Pose2>& path,
                            double sigma_m = 0) {
  Random random(1);
  ScanOdometry scans;
  std::vector<Pose2> poses;
  for (std::size_t i = 0; i < path.size(); ++i) {
    std::vector<Vec2> points = cast_points(walls, path[i]);
    for (Vec2& p : points) p *= 1 + random.normal(sigma_m) / p.norm();
    scans.step(points, static_cast<double>(i) * kScan_s);
    poses.push_back(scans.T_first_laser());
  }
  return poses;
}

std::vector<Pose2> eight(double duration_s) {
  std::vector<Pose2> path;
  for (int i = 0; i * kScan_s <= duration_s; ++i) path.push_back(on_figure_of_eight(i * kScan_s));
  return path;
}

TEST(ScanOdometry, TheFirstScanIsWhereItBegins) {
  ScanOdometry scans;
  const ScanMotion first = scans.step(cast_points(uneven_room(), {3, 2, 1}), 7);
  EXPECT_THAT(first.T_last_now, PoseNear(Pose2{}, 0, 0));
  EXPECT_THAT(scans.T_first_laser(), PoseNear(Pose2{}, 0, 0));
  EXPECT_EQ(first.share, 1);
}

TEST(ScanOdometry, FollowsADriveThroughARoom) {
  const std::vector<Pose2> path = eight(25), poses = followed(uneven_room(), path);
  for (std::size_t i = 0; i < path.size(); ++i)
    ASSERT_THAT(poses[i], PoseNear(between(path.front(), path[i]), 0.03, 0.5 * kDegree)) << "scan " << i;
}

TEST(ScanOdometry, FollowsItWithNoise) {
  const std::vector<Pose2> path = eight(25), poses = followed(uneven_room(), path, 0.02);
  EXPECT_THAT(poses.back(), PoseNear(between(path.front(), path.back()), 0.1, 1 * kDegree));
}

TEST(ScanOdometry, DoesNotDependOnWhereTheBuildingIs) {
  const Pose2 T_elsewhere{-30, 12, 0};
  std::vector<Segment2> walls = uneven_room();
  std::vector<Pose2> path = eight(8);
  const std::vector<Pose2> poses = followed(walls, path);
  for (Segment2& wall : walls) wall = T_elsewhere * wall;
  for (Pose2& pose : path) pose = T_elsewhere * pose;
  EXPECT_THAT(followed(walls, path).back(), PoseNear(poses.back(), 1e-4, 1e-4));
}

TEST(ScanOdometry, StaysWhereItStands) {
  const std::vector<Pose2> poses = followed(uneven_room(), std::vector<Pose2>(200, {3, 2, 1}), 0.01);
  EXPECT_THAT(poses.back(), PoseNear(Pose2{}, 0.01, 0.2 * kDegree));
}

TEST(ScanOdometry, ItsStepsAddUpToItsPose) {
  ScanOdometry scans;
  Pose2 sum;
  double time_s = 0;
  for (const Pose2& pose : eight(3)) {
    sum = sum * scans.step(cast_points(uneven_room(), pose), time_s).T_last_now;
    time_s += kScan_s;
  }
  EXPECT_THAT(scans.T_first_laser(), PoseNear(sum, 1e-9, 1e-9));
}

TEST(ScanOdometry, FindsAMoveThatItCouldNotExpect) {
  const Pose2 moved{0.5, -0.3, 30 * kDegree};
  const Pose2 start{3, 2, 1};
  ScanOdometry scans;
  scans.step(cast_points(uneven_room(), start), 0);
  const ScanMotion motion = scans.step(cast_points(uneven_room(), start * moved), 0.4);
  EXPECT_THAT(motion.T_last_now, PoseNear(moved, 0.02, 0.3 * kDegree));
  EXPECT_GT(motion.share, 0.8);
}

TEST(ScanOdometry, KnowsThatItGuessesTheDistanceAlongABareCorridor) {
  ScanOdometry scans;
  scans.step(cast_points(endless_corridor(), {0, 0, 0}), 0);
  const ScanMotion motion = scans.step(cast_points(endless_corridor(), {0.05, 0.02, 0}), kScan_s);
  EXPECT_NEAR(motion.T_last_now.y, 0.02, 0.003);
  EXPECT_LT(motion.information(0, 0), 1e-3 * motion.information(1, 1));
}

TEST(ScanOdometry, KeepsItsSpeedWhereACorridorGetsBare) {
  std::vector<Segment2> with_end = endless_corridor();
  with_end.push_back({{15, -1}, {15, 1}});
  ScanOdometry scans;
  constexpr double kStep_m = 0.05;
  for (int i = 0; i <= 100; ++i) {
    const Pose2 T_corridor_laser{i * kStep_m, 0, 0};
    scans.step(cast_points(i < 40 ? with_end : endless_corridor(), T_corridor_laser), i * kScan_s);
  }
  EXPECT_THAT(scans.T_first_laser(), PoseNear(Pose2{100 * kStep_m, 0, 0}, 0.3, 0.5 * kDegree));
}

TEST(ScanOdometry, AScanOfNothingFitsNothing) {
  ScanOdometry scans;
  scans.step(cast_points(uneven_room(), {3, 2, 1}), 0);
  const ScanMotion blind = scans.step({}, kScan_s);
  EXPECT_EQ(blind.share, 0);
  EXPECT_THAT(blind.T_last_now, PoseNear(Pose2{}, 1e-9, 1e-9));
  EXPECT_THAT(scans.step(cast_points(uneven_room(), {3.02, 2, 1}), 2 * kScan_s).T_last_now.position(),
              PointNear(rotate(-1, Vec2(0.02, 0)), 0.003));
}

TEST(ScanOdometry, TellsHowWellAScanFitsElsewhere) {
  const Pose2 start{3, 2, 1}, moved{0.4, 0.1, 0.2};
  ScanOdometry scans;
  scans.step(cast_points(uneven_room(), start), 0);
  const std::vector<Vec2> points = cast_points(uneven_room(), start * moved);
  EXPECT_GT(scans.share_at(points, moved), 0.9);
  EXPECT_LT(scans.share_at(points, moved * Pose2{1, 1, 1}), 0.6);
  EXPECT_THAT(scans.T_first_laser(), PoseNear(Pose2{}, 0, 0)) << "asking moves nothing";
}

TEST(PointsOf, TakesReadingsBetweenTheVehicleItselfAndTheReachInOrder) {
  const LaserScanner laser{0, 90 * kDegree, 8, {1, 1, 1}};
  std::vector<Vec2> points = {{9, 9}};
  points_of(laser, std::vector<float>{2, 0.04F, 0, 3, 8, 7.9F}, points);
  ASSERT_EQ(points.size(), 3U);
  EXPECT_THAT(points[0], PointNear(Vec2(2, 0), 1e-6));
  EXPECT_THAT(points[1], PointNear(Vec2(0, -3), 1e-6));
  EXPECT_THAT(points[2], PointNear(Vec2(0, 7.9), 1e-6));
}

TEST(PointsOf, LeavesOutWhatIsTooFarAndWhatIsNoNumber) {
  const LaserScanner laser{0, 1 * kDegree, 80, {}};
  std::vector<Vec2> points;
  constexpr float kInfinite = std::numeric_limits<float>::infinity();
  points_of(laser, std::vector<float>{20.1F, kInfinite, std::numeric_limits<float>::quiet_NaN(), -1}, points);
  EXPECT_TRUE(points.empty());
}

}  // namespace
}  // namespace aisle
