#include "aisle/formats/sessions/timed_scans.hpp"

#include <gmock/gmock.h>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

/// A scanner of four readings, 90 degrees apart, and a scan a second.
LaserLog four_beams(int scans) {
  LaserLog log;
  log.laser() = {-90 * kDegree, 90 * kDegree, 10, {0.1, 0, 0}};
  for (int i = 0; i < scans; ++i) {
    LaserScan& scan = log.scans.emplace_back();
    scan.time_s = 100 + i;
    scan.ranges_m = {1, 2, 3, static_cast<float>(i)};
  }
  return log;
}

TEST(TimedScans, KeepScansOfTheFirstScannersBeams) {
  LaserLog log = four_beams(3);
  log.odometry = {{100, {0, 0, 0}}, {102, {1, 0, 0}}};
  Problems warnings;
  const TimedScans timed = timed_scans(log, "log", warnings);
  ASSERT_THAT(timed.scans, SizeIs(3));
  EXPECT_EQ(to_string(warnings), "");
  EXPECT_EQ(timed.scans[2].scan.ranges_m, log.scans[2].ranges_m);
  EXPECT_EQ(timed.scans[1].stamp_s, 101);
  EXPECT_EQ(timed.scans[1].scan.stamp_s, 101);
  ASSERT_TRUE(timed.scans[1].T_odom_vehicle);
  EXPECT_DOUBLE_EQ(timed.scans[1].T_odom_vehicle->x, 0.5);
  EXPECT_EQ(timed.scanner.T_vehicle_laser.x, 0.1);
}

TEST(TimedScans, AScanThatTakesTimeBeginsBeforeItsMiddle) {
  LaserLog log = four_beams(1);
  log.scans[0].beams = ScanBeams{-90 * kDegree, 90 * kDegree, 0.02};
  Problems warnings;
  const TimedScans timed = timed_scans(log, "log", warnings);
  EXPECT_NEAR(timed.scans[0].scan.stamp_s, 100 - 0.03, 1e-9);
  EXPECT_EQ(timed.scans[0].reading_period_s, 0.02);
  EXPECT_EQ(timed.scans[0].scan.ranges_m, log.scans[0].ranges_m);
}

TEST(TimedScans, OtherBeamsGiveTheReadingNextToThoseOfTheFirstScan) {
  LaserLog log = four_beams(4);
  log.scans[1].beams = ScanBeams{-80 * kDegree, 90 * kDegree, 0};  // turned by less than half a step
  log.scans[2].ranges_m = {5, 6};
  log.scans[3].beams = ScanBeams{180 * kDegree, 90 * kDegree, 0};  // begins behind, and goes on over it
  log.scans[3].ranges_m = {4, 1, 2, 3};
  Problems warnings;
  const TimedScans timed = timed_scans(log, "log", warnings);
  EXPECT_THAT(timed.scans[1].scan.ranges_m, ElementsAre(1, 2, 3, 1));
  EXPECT_THAT(timed.scans[2].scan.ranges_m, ElementsAre(5, 6, 0, 0));
  EXPECT_THAT(timed.scans[3].scan.ranges_m, ElementsAre(1, 2, 3, 4));
  EXPECT_THAT(to_string(warnings), HasSubstr("log: 3 scans have other beams than the first"));
}

TEST(TimedScans, OfSeveralScannersTheFirstIsTaken) {
  LaserLog log = four_beams(3);
  log.lasers.push_back(log.laser());
  log.scans[0].laser = 1;
  log.scans[2].time_s = log.scans[1].time_s;
  Problems warnings;
  const TimedScans timed = timed_scans(log, "log", warnings);
  EXPECT_THAT(timed.scans, SizeIs(1));
  EXPECT_EQ(timed.left_out, 2U);
  EXPECT_THAT(to_string(warnings), testing::AllOf(HasSubstr("1 scans of other scanners"),
                                                  HasSubstr("1 scans have no later stamp")));
}

TEST(TimedScans, TheScannerIsOneThatAVehicleFileMayDescribe) {
  LaserLog log = four_beams(1);
  log.laser() = {-190 * kDegree, 90 * kDegree, 1000, {}};
  Problems warnings;
  const TimedScans timed = timed_scans(log, "log", warnings);
  EXPECT_NEAR(timed.scanner.first_angle_rad, 170 * kDegree, 1e-9);
  EXPECT_EQ(timed.scanner.range_max_m, 200);
  EXPECT_EQ(timed.scans[0].scan.ranges_m, log.scans[0].ranges_m);
}

}  // namespace
}  // namespace aisle
