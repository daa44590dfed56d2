#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "pose_matchers.hpp"
#include "recorded_runs.hpp"

namespace aisle {
namespace {

/// Logs with hardly any information: the result must still consist of finite numbers, with one pose per scan.
class PoorLog : public testing::Test {
 protected:
  PoorLog() : log_(recorded("small-office").log) { keep_scans(100); }

  void keep_scans(std::size_t count) {
    log_.scans.resize(count);
    log_.odometry.resize(count);
  }

  void expect_finite_poses() const {
    for (const MapResult& result : {mapped(log_), mapped_as_published(log_)}) {
      EXPECT_THAT(result.T_map_vehicle, testing::SizeIs(log_.scans.size()));
      EXPECT_THAT(result.T_map_vehicle_online, testing::SizeIs(log_.scans.size()));
      EXPECT_TRUE(std::all_of(result.T_map_vehicle.begin(), result.T_map_vehicle.end(), is_finite));
      EXPECT_TRUE(
          std::all_of(result.T_map_vehicle_online.begin(), result.T_map_vehicle_online.end(), is_finite));
      EXPECT_TRUE(std::isfinite(result.path_m));
    }
  }

  static bool is_finite(const Pose2& pose) { return pose.is_finite(); }

  LaserLog log_;
};

TEST_F(PoorLog, OfOneScan) {
  keep_scans(1);
  expect_finite_poses();
}

TEST_F(PoorLog, OfTwoScansAtOneTime) {
  keep_scans(2);
  log_.scans[1].time_s = log_.scans[0].time_s;
  log_.odometry[1].time_s = log_.odometry[0].time_s;
  expect_finite_poses();
}

TEST_F(PoorLog, WithoutAnyReading) {
  for (LaserScan& scan : log_.scans) std::fill(scan.ranges_m.begin(), scan.ranges_m.end(), 0.0F);
  expect_finite_poses();
}

TEST_F(PoorLog, WithNothingInReach) {
  for (LaserScan& scan : log_.scans) {
    std::fill(scan.ranges_m.begin(), scan.ranges_m.end(), static_cast<float>(log_.laser().range_max_m));
  }
  expect_finite_poses();
}

TEST_F(PoorLog, OfOdometryThatCountsNothing) {
  for (OdometrySample& sample : log_.odometry) sample.T_odom_vehicle = {1, 2, 0.5};
  expect_finite_poses();
}

TEST_F(PoorLog, OfAVehicleThatStands) {
  for (LaserScan& scan : log_.scans) scan.ranges_m = log_.scans.front().ranges_m;
  for (OdometrySample& sample : log_.odometry) sample.T_odom_vehicle = {1, 2, 0.5};
  expect_finite_poses();
  const std::vector<Pose2> poses = mapped(log_).T_map_vehicle;
  for (const Pose2& pose : poses) EXPECT_THAT(pose, PoseNear(poses.front(), 0.001, 0.001));
}

TEST_F(PoorLog, OfOdometryThatJumps) {
  for (std::size_t i = 0; i < log_.odometry.size(); ++i)
    log_.odometry[i].T_odom_vehicle.x += i % 2 == 0 ? 0 : 1e6;
  expect_finite_poses();
}

}  // namespace
}  // namespace aisle
