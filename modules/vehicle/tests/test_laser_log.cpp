#include <gtest/gtest.h>

#include "aisle/vehicle/laser_log.hpp"

namespace aisle {
namespace {

LaserLog log_at(const std::vector<double>& times_s) {
  LaserLog log;
  for (const double time_s : times_s) log.scans.push_back({.time_s = time_s});
  return log;
}

TEST(LaserLog, ThePeriodIsTheUsualStepWhateverTheLongest) {
  EXPECT_EQ(log_at({0, 1, 2, 60, 61}).scan_period_s(), 1);
  EXPECT_EQ(log_at({5, 5.25}).scan_period_s(), 0.25);
}

TEST(LaserLog, FewerThanTwoScansHaveNoPeriod) {
  EXPECT_EQ(log_at({}).scan_period_s(), 0);
  EXPECT_EQ(log_at({5}).scan_period_s(), 0);
}

TEST(LaserScanner, BeamsRunCounterClockwiseFromTheFirst) {
  const LaserScanner laser{.first_angle_rad = -1.5, .angle_step_rad = 0.5};
  EXPECT_EQ(laser.beam_angle(0), -1.5);
  EXPECT_EQ(laser.beam_angle(3), 0);
  EXPECT_EQ(laser.beam_angle(6), 1.5);
}

}  // namespace
}  // namespace aisle
