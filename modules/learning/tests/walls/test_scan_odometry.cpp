#include "aisle/learning/walls/scan_odometry.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "aisle/learning/walls/motion_noise.hpp"
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
  EXPECT_THAT(first.T_last_now.mean, PoseNear(Pose2{}, 0, 0));
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
    sum = sum * scans.step(cast_points(uneven_room(), pose), time_s).T_last_now.mean;
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
  EXPECT_THAT(motion.T_last_now.mean, PoseNear(moved, 0.02, 0.3 * kDegree));
  EXPECT_GT(motion.share, 0.8);
}

TEST(ScanOdometry, KnowsThatItGuessesTheDistanceAlongABareCorridor) {
  ScanOdometry scans;
  scans.step(cast_points(endless_corridor(), {0, 0, 0}), 0);
  const ScanMotion motion = scans.step(cast_points(endless_corridor(), {0.05, 0.02, 0}), kScan_s);
  EXPECT_NEAR(motion.T_last_now.mean.y, 0.02, 0.003);
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
  EXPECT_THAT(blind.T_last_now.mean, PoseNear(Pose2{}, 1e-9, 1e-9));
  EXPECT_THAT(scans.step(cast_points(uneven_room(), {3.02, 2, 1}), 2 * kScan_s).T_last_now.mean.position(),
              PointNear(rotate(-1, Vec2(0.02, 0)), 0.003));
}

/// The motion by scans along a path and by wheels that were at `counted`.
struct WithWheels {
  std::vector<Pose2> poses;     ///< of the laser, in the frame of the first
  std::vector<double> sigma_m;  ///< of each step, along it
};

WithWheels with_wheels(const std::vector<Segment2>& walls, const std::vector<Pose2>& path,
                       const std::vector<Pose2>& counted) {
  Random random(1);
  ScanOdometry scans;
  WithWheels result;
  for (std::size_t i = 0; i < path.size(); ++i) {
    std::vector<Vec2> points = cast_points(walls, path[i]);
    for (Vec2& p : points) p *= 1 + random.normal(0.01) / p.norm();
    const Pose2 step = i > 0 ? between(counted[i - 1], counted[i]) : Pose2{};
    const ScanMotion motion = scans.step(points, static_cast<double>(i) * kScan_s,
                                         UncertainPose2{step, MotionNoise{}.covariance(step)});
    result.poses.push_back(scans.T_first_laser());
    result.sigma_m.push_back(std::sqrt(motion.T_last_now.covariance(0, 0)));
  }
  return result;
}

std::vector<Pose2> straight(std::size_t count, double step_m) {
  std::vector<Pose2> path;
  for (std::size_t i = 0; i < count; ++i) path.push_back({static_cast<double>(i) * step_m, 0.1, 0});
  return path;
}

void expect_along(const std::vector<Pose2>& path, const std::vector<Pose2>& poses) {
  for (std::size_t i = 0; i < path.size(); ++i)
    ASSERT_THAT(poses[i], PoseNear(between(path.front(), path[i]), 0.06, 1 * kDegree)) << "scan " << i;
}

TEST(ScanOdometry, WheelsThatAreRightStayRight) {
  const std::vector<Pose2> path = eight(25);
  expect_along(path, with_wheels(uneven_room(), path, path).poses);
}

TEST(ScanOdometry, AlongABareCorridorTheWheelsDecide) {
  const std::vector<Pose2> path = straight(150, 0.05);
  const WithWheels found = with_wheels(endless_corridor(), path, path);
  EXPECT_THAT(found.poses.back(), PoseNear(between(path.front(), path.back()), 0.04, 0.5 * kDegree));
  const double by_wheels_m = std::sqrt(MotionNoise{}.covariance({0.05, 0, 0})(0, 0));
  EXPECT_GT(found.sigma_m.back(), 0.8 * by_wheels_m);
  EXPECT_LE(found.sigma_m.back(), by_wheels_m);
}

TEST(ScanOdometry, FollowsWhereWheelsFreezeAndCatchUp) {
  const std::vector<Pose2> path = eight(25);
  std::vector<Pose2> counted = path;
  for (std::size_t first = 40; first + 20 < path.size(); first += 60)
    for (std::size_t i = first; i < first + 20; ++i) counted[i] = counted[first];
  expect_along(path, with_wheels(uneven_room(), path, counted).poses);
}

TEST(ScanOdometry, FollowsWhereWheelsSlip) {
  const std::vector<Pose2> path = eight(12);
  for (const double factor : {1.6, 0.4, -1.0}) {
    std::vector<Pose2> counted{path.front()};
    for (std::size_t i = 1; i < path.size(); ++i) {
      const Pose2 step = between(path[i - 1], path[i]);
      const double slip = i > 30 && i < 70 ? factor : 1;
      counted.push_back(counted.back() * Pose2{slip * step.x, slip * step.y, step.theta});
    }
    expect_along(path, with_wheels(uneven_room(), path, counted).poses);
  }
}

TEST(ScanOdometry, FollowsWhereWheelsBeginAgainElsewhere) {
  const std::vector<Pose2> path = eight(12);
  std::vector<Pose2> counted = path;
  for (std::size_t i = 60; i < path.size(); ++i) counted[i] = Pose2{-7, 4, 2} * path[i];
  expect_along(path, with_wheels(uneven_room(), path, counted).poses);
}

TEST(ScanOdometry, LateWheelsDoNotSpoilWhatIsKnown) {
  std::vector<Pose2> path(20, {3, 2, 0}), counted = path;
  path.insert(path.end(), 20, {3, 2, 110 * kDegree});
  counted.push_back({3, 2, 20 * kDegree});  // of the turn, the rest comes with the next scan
  counted.insert(counted.end(), 19, path.back());
  EXPECT_THAT(with_wheels(uneven_room(), path, counted).poses.back(),
              PoseNear(between(path.front(), path.back()), 0.04, 1 * kDegree));
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

TEST(PointsOf, PlacesReadingsAsFromTheMiddleOfTheSweep) {
  const LaserScanner laser{0, 90 * kDegree, 8, {}};
  std::vector<Vec2> points;
  points_of(laser, std::vector<float>{2, 2, 2}, points, {0.4, 0, 90 * kDegree});
  ASSERT_EQ(points.size(), 3U);
  EXPECT_THAT(points[0], PointNear(Vec2(2 * unit(-45 * kDegree) - Vec2(0.2, 0)), 1e-6));
  EXPECT_THAT(points[1], PointNear(Vec2(0, 2), 1e-6));
  EXPECT_THAT(points[2], PointNear(Vec2(2 * unit(225 * kDegree) + Vec2(0.2, 0)), 1e-6));
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
