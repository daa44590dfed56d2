#include "aisle/learning/walls/map_building.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "pose_matchers.hpp"
#include "walls/recorded_drive.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

MapResult map_of(const LaserLog& log, const KnownOfLog& known = {}) {
  SilentProgress progress;
  return build_map(log, {}, known, false, progress);
}

/// How far the last pose is from where the drive ended, seen from its begin.
Pose2 off_at_end(const LaserLog& log, const MapResult& map) {
  const double begin_s = log.scans.front().time_s, end_s = log.scans.back().time_s;
  const Pose2 driven = between(on_figure_of_eight(begin_s), on_figure_of_eight(end_s));
  return between(driven, between(map.T_map_vehicle.front(), map.T_map_vehicle.back()));
}

TEST(MapBuilding, SoundOdometryIsNotContradicted) {
  const LaserLog log = RecordedDrive{.range_sigma_m = 0.01}.log();
  const MapResult map = map_of(log), alone = map_of(log, {.odometry_noise = true});
  EXPECT_THAT(map.warnings, IsEmpty());
  EXPECT_THAT(off_at_end(log, map), PoseNear(Pose2{}, 0.02, 0.5 * kDegree));
  EXPECT_THAT(off_at_end(log, alone), PoseNear(Pose2{}, 0.02, 0.5 * kDegree));
}

TEST(MapBuilding, OdometryThatBeginsAgainIsContradictedAndSaid) {
  LaserLog log = RecordedDrive{.range_sigma_m = 0.01}.log();
  for (std::size_t i = 300; i < log.odometry.size(); ++i)
    log.odometry[i].T_odom_vehicle = Pose2{4, -2, 2} * log.odometry[i].T_odom_vehicle;
  const MapResult map = map_of(log);
  EXPECT_THAT(off_at_end(log, map), PoseNear(Pose2{}, 0.05, 1 * kDegree));
  ASSERT_EQ(map.warnings.size(), 1U);
  EXPECT_THAT(map.warnings[0].what, HasSubstr("contradicts the scans"));
  EXPECT_NEAR(static_cast<double>(map.warnings[0].where.line), static_cast<double>(log.odometry[300].line),
              6);
}

TEST(MapBuilding, OdometryThatFreezesAndCatchesUpLeavesTheMapAsItIs) {
  LaserLog log = RecordedDrive{.range_sigma_m = 0.01}.log();
  for (std::size_t first = 101; first + 25 < log.odometry.size(); first += 100) {
    for (std::size_t i = first; i < first + 25; ++i)
      log.odometry[i].T_odom_vehicle = log.odometry[first - 1].T_odom_vehicle;
  }
  EXPECT_THAT(off_at_end(log, map_of(log)), PoseNear(Pose2{}, 0.05, 1 * kDegree));
}

}  // namespace
}  // namespace aisle
