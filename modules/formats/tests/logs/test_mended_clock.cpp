#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "aisle/core/random.hpp"
#include "logs/mended_clock.hpp"

namespace aisle {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;
using testing::Pointwise;

/// The repaired times of scans with these recorded stamps, one per line.
std::vector<double> mended(const std::vector<double>& stamps_s, ClockRepair* repair = nullptr) {
  LaserLog log;
  std::vector<RecordedStamp> stamps;
  for (const double stamp_s : stamps_s) {
    stamps.push_back({stamp_s, static_cast<long>(stamps.size()) + 1});
    log.scans.emplace_back();
  }
  const ClockRepair done = mend_clock(log, stamps, {});
  if (repair) *repair = done;
  std::vector<double> times;
  for (const LaserScan& scan : log.scans) times.push_back(scan.time_s);
  return times;
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
  EXPECT_THAT(mended({7, 7, 7, 7, 7}, &repair), Pointwise(DoubleEq(), {7.0, 7.0, 7.1, 7.2, 7.3}));
  EXPECT_TRUE(repair.by_nominal_step);
  EXPECT_EQ(repair.places, 3U);
  EXPECT_EQ(repair.first_line, 3);
}

TEST(MendedClock, AClockWithImplausibleStepsIsGivenANominalStep) {
  ClockRepair repair;
  EXPECT_THAT(mended({500, 5, 500, 5}, &repair), Pointwise(DoubleEq(), {500.0, 500.1, 500.2, 500.3}));
  EXPECT_TRUE(repair.by_nominal_step);
  EXPECT_EQ(repair.places, 3U);
}

TEST(MendedClock, AClockThatAdvancesIsNotGivenANominalStep) {
  ClockRepair repair;
  mended({5, 6, 7, 1, 2}, &repair);
  EXPECT_FALSE(repair.by_nominal_step);
}

TEST(MendedClock, ScansAndOdometryOfAStoppedClockStayTogether) {
  LaserLog log;
  log.scans.resize(5);
  log.odometry.resize(5);
  for (std::size_t i = 0; i < 5; ++i) log.scans[i].odometry_known = i + 1;
  const std::vector<RecordedStamp> stamps(5, {7, 1});
  mend_clock(log, stamps, stamps);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(log.scans[i].time_s, log.odometry[i].time_s);
  EXPECT_NEAR(log.scan_period_s(), kNominalStep_s, 1e-12);
}

TEST(MendedClock, ScansAndOdometryKeepTheirDistance) {
  LaserLog log;
  log.scans.resize(3);
  for (std::size_t i = 0; i < 3; ++i) log.scans[i].odometry_known = i + 1;
  log.odometry.resize(3);
  const std::vector<RecordedStamp> odometry = {{100, 1}, {101, 3}, {11, 5}};
  const std::vector<RecordedStamp> scans = {{100.25, 2}, {101.25, 4}, {11.25, 6}};
  EXPECT_EQ(mend_clock(log, scans, odometry).places, 1U);
  EXPECT_EQ(log.odometry[2].time_s, 102);
  EXPECT_EQ(log.scans[2].time_s, 102.25);
}

RC_GTEST_PROP(MendedClock, NeverGoesBack, (std::vector<double> stamps_s)) {
  const std::vector<double> times = mended(stamps_s);
  RC_ASSERT(std::is_sorted(times.begin(), times.end()));
}

}  // namespace
}  // namespace aisle
