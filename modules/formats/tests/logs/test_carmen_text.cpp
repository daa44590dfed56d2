#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <stdexcept>

#include "aisle/core/random.hpp"
#include "aisle/formats/logs/carmen_log.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

LaserLog any_log(Random& random) {
  const auto beams = static_cast<std::size_t>(random.uniform(2, 400));
  LaserLog log;
  log.laser() = flaser_scanner(beams);
  log.laser().range_max_m = random.uniform(5, 80);
  log.laser().T_vehicle_laser = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-3, 3)};
  double time_s = random.uniform(0, 2e9);
  for (std::size_t i = 0; i < 1 + random.index(5); ++i) {
    LaserScan scan;
    scan.stamp_s = scan.time_s = time_s += random.uniform(0.01, 1);
    for (std::size_t k = 0; k < beams; ++k)
      scan.ranges_m.push_back(static_cast<float>(random.uniform(0, 80)));
    scan.odometry_known = i + 1;
    log.scans.push_back(scan);
    log.odometry.push_back(
        {time_s, {random.uniform(-99, 99), random.uniform(-99, 99), random.uniform(-9, 9)}});
  }
  return log;
}

RC_GTEST_PROP(CarmenText, ReadingItGivesTheSameLog, (std::uint64_t seed)) {
  Random random(seed);
  const LaserLog log = any_log(random);
  const auto again = parse_carmen_log(carmen_text(log), "written");
  RC_ASSERT(again.ok());
  const LaserLog& read = again->log;
  RC_ASSERT(read.laser().first_angle_rad == log.laser().first_angle_rad);
  RC_ASSERT(read.laser().angle_step_rad == log.laser().angle_step_rad);
  RC_ASSERT(std::abs(read.laser().range_max_m - log.laser().range_max_m) < 1e-9);
  RC_ASSERT(testing::Matches(PoseNear(log.laser().T_vehicle_laser, 0, 0))(read.laser().T_vehicle_laser));
  RC_ASSERT(read.scans.size() == log.scans.size());
  RC_ASSERT(read.odometry.size() == log.odometry.size());
  for (std::size_t i = 0; i < log.scans.size(); ++i) {
    RC_ASSERT(read.scans[i].ranges_m == log.scans[i].ranges_m);
    RC_ASSERT(read.scans[i].stamp_s == log.scans[i].stamp_s);
    RC_ASSERT(read.scans[i].time_s == log.scans[i].time_s);
    RC_ASSERT(read.scans[i].odometry_known == log.scans[i].odometry_known);
    RC_ASSERT(read.odometry[i].time_s == log.odometry[i].time_s);
    RC_ASSERT(
        testing::Matches(PoseNear(log.odometry[i].T_odom_vehicle, 0, 0))(read.odometry[i].T_odom_vehicle));
  }
}

TEST(CarmenText, RefusesWhatAFlaserLineCannotExpress) {
  Random random(1);
  LaserLog without_odometry = any_log(random);
  without_odometry.odometry.pop_back();
  EXPECT_THROW(carmen_text(without_odometry), std::invalid_argument);
  LaserLog other_beams = any_log(random);
  other_beams.laser().first_angle_rad += 0.1;
  EXPECT_THROW(carmen_text(other_beams), std::invalid_argument);
  LaserLog uneven = any_log(random);
  uneven.scans.push_back(uneven.scans.back());
  uneven.odometry.push_back(uneven.odometry.back());
  uneven.scans.back().ranges_m.push_back(1);
  EXPECT_THROW(carmen_text(uneven), std::invalid_argument);
}

}  // namespace
}  // namespace aisle
