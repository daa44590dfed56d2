#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "aisle/core/angle.hpp"
#include "logs/mended_clock.hpp"

namespace aisle {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;
using testing::Pointwise;

/// The repaired times of scans with these recorded stamps, one per line.
std::vector<double> mended(const std::vector<double>& stamps_s, ClockRepair* repair = nullptr) {
  LaserLog log;
  for (const double stamp_s : stamps_s) {
    LaserScan& scan = log.scans.emplace_back();
    scan.stamp_s = stamp_s;
    scan.line = static_cast<long>(log.scans.size());
  }
  const ClockRepair done = mend_clock(log);
  if (repair) *repair = done;
  std::vector<double> times;
  for (const LaserScan& scan : log.scans) times.push_back(scan.time_s);
  return times;
}

/// Scans with their own poses along x, at these stamps.
LaserLog log_along_x(const std::vector<double>& stamps_s, double step_m) {
  LaserLog log;
  for (std::size_t i = 0; i < stamps_s.size(); ++i) {
    log.odometry.push_back({stamps_s[i], {step_m * static_cast<double>(i), 0, 0}, static_cast<long>(i) + 1});
    LaserScan& scan = log.scans.emplace_back();
    scan.stamp_s = stamps_s[i];
    scan.odometry_known = i + 1;
  }
  return log;
}

TEST(MendedClock, LeavesAGoodClockAloneWithItsPausesAndASingleRepeatedStamp) {
  EXPECT_THAT(mended({5, 6, 7, 7, 8, 38, 39}), ElementsAre(5, 6, 7, 7, 8, 38, 39));
}

TEST(MendedClock, AStepBackOrAJumpBecomesAUsualStep) {
  ClockRepair repair;
  EXPECT_THAT(mended({5, 6, 7, 1, 2, 100, 101}, &repair), ElementsAre(5, 6, 7, 8, 9, 10, 11));
  EXPECT_EQ(repair.places, 2U);
  EXPECT_EQ(repair.first_line, 4);
}

TEST(MendedClock, AClockThatPausesIsMadeToAdvance) {
  EXPECT_THAT(mended({5, 6, 7, 7, 7, 7, 8, 9, 10}), ElementsAre(5, 6, 7, 7, 8, 9, 10, 11, 12));
}

TEST(MendedClock, AStoppedClockIsGivenANominalStep) {
  ClockRepair repair;
  EXPECT_THAT(mended({7, 7, 7, 7, 7}, &repair), Pointwise(DoubleEq(), {7.0, 7.1, 7.2, 7.3, 7.4}));
  EXPECT_TRUE(repair.by_motion);
  EXPECT_EQ(repair.places, 4U);
  EXPECT_EQ(repair.first_line, 2);
}

TEST(MendedClock, AClockWithImplausibleStepsIsGivenANominalStep) {
  ClockRepair repair;
  EXPECT_THAT(mended({500, 5, 500, 5}, &repair), Pointwise(DoubleEq(), {500.0, 500.1, 500.2, 500.3}));
  EXPECT_TRUE(repair.by_motion);
  EXPECT_EQ(repair.places, 3U);
}

TEST(MendedClock, AClockThatAdvancesIsNotGivenANominalStep) {
  ClockRepair repair;
  mended({5, 6, 7, 1, 2}, &repair);
  EXPECT_FALSE(repair.by_motion);
}

TEST(MendedClock, OfAStoppedClockTheTimesFollowTheMotion) {
  LaserLog log = log_along_x({7, 7, 7, 7}, 1);
  const ClockRepair repair = mend_clock(log);
  EXPECT_TRUE(repair.by_motion);
  for (std::size_t i = 0; i < log.scans.size(); ++i) {
    EXPECT_DOUBLE_EQ(log.scans[i].time_s, 7 + 2.0 * static_cast<double>(i));
    EXPECT_EQ(log.scans[i].time_s, log.odometry[i].time_s);
  }
}

TEST(MendedClock, OfAClockThatMostlyMakesNoSenseTheTimesFollowTheMotion) {
  LaserLog log = log_along_x({7, 4e9, 4e9, 4e9, -2, 4e9}, 1);
  const ClockRepair repair = mend_clock(log);
  EXPECT_TRUE(repair.by_motion);
  for (std::size_t i = 0; i < log.scans.size(); ++i) {
    EXPECT_DOUBLE_EQ(log.scans[i].time_s, 7 + 2.0 * static_cast<double>(i));
    EXPECT_EQ(log.scans[i].time_s, log.odometry[i].time_s);
  }
}

TEST(MendedClock, ALongWayAtABrokenPlaceTakesItsTime) {
  LaserLog log = log_along_x({7, 7.5, 8, 2, 2.5}, 0.1);
  for (std::size_t i = 3; i < 5; ++i) log.odometry[i].T_odom_vehicle.x += 3;
  mend_clock(log);
  EXPECT_DOUBLE_EQ(log.scans[3].time_s, 8 + 3.1 / 0.5);
  EXPECT_DOUBLE_EQ(log.scans[4].time_s, log.scans[3].time_s + 0.5);
}

TEST(MendedClock, ATurnTakesItsTime) {
  LaserLog log = log_along_x({7, 7}, 0);
  log.odometry[1].T_odom_vehicle.theta = 60 * kDegree;
  mend_clock(log);
  EXPECT_NEAR(log.scans[1].time_s, 9, 1e-9);
}

TEST(MendedClock, RoundedStampsAreSpreadEvenly) {
  ClockRepair repair;
  EXPECT_THAT(mended({10, 11, 11, 11, 11, 12, 12, 13, 13, 13, 13}, &repair),
              Pointwise(DoubleEq(), {10.0, 11.0, 11.25, 11.5, 11.75, 12.0, 12.5, 13.0, 13.5, 14.0, 14.5}));
  EXPECT_EQ(repair.first_rounded_line, 3);
  EXPECT_EQ(repair.places, 0U);
}

TEST(MendedClock, ScansAndOdometryKeepTheirDistance) {
  LaserLog log;
  log.scans.resize(3);
  for (std::size_t i = 0; i < 3; ++i) {
    log.scans[i].odometry_known = i + 1;
    log.scans[i].stamp_s = std::vector<double>{100.25, 101.25, 11.25}[i];
  }
  log.odometry = {{100, {}, 1}, {101, {}, 3}, {11, {}, 5}};
  EXPECT_EQ(mend_clock(log).places, 1U);
  EXPECT_EQ(log.odometry[2].time_s, 102);
  EXPECT_EQ(log.scans[2].time_s, 102.25);
}

RC_GTEST_PROP(MendedClock, NeverGoesBack, (std::vector<double> stamps_s)) {
  const std::vector<double> times = mended(stamps_s);
  RC_ASSERT(std::is_sorted(times.begin(), times.end()));
}

}  // namespace
}  // namespace aisle
