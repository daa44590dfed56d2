#include "aisle/guidance/landmarks/expectation_monitor.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace aisle {
namespace {

std::vector<ExpectedLandmark> expected_of(int all, int seen) {
  std::vector<ExpectedLandmark> expected;
  for (int i = 0; i < all; ++i) expected.push_back({.landmark = i, .is_seen = i < seen});
  return expected;
}

/// @return at which of these images it notices; 0: at none
int noticed_at(ExpectationMonitor& watch, int images, int all, int seen) {
  for (int i = 1; i <= images; ++i) {
    if (watch.look(expected_of(all, seen))) return i;
  }
  return 0;
}

TEST(ExpectationMonitor, MostOfWhatShouldBeSeenMayBeMissing) {
  ExpectationMonitor watch;
  EXPECT_EQ(noticed_at(watch, 100, 10, 2), 0);
}

TEST(ExpectationMonitor, NoticesWithinTenImagesThatTheFewThatWereSeenAreNotAnyMore) {
  ExpectationMonitor watch;
  noticed_at(watch, 100, 12, 3);
  EXPECT_EQ(noticed_at(watch, 100, 12, 0), 7);
}

TEST(ExpectationMonitor, NoticesWithinFourImagesThatTheManyThatWereSeenAreNotAnyMore) {
  ExpectationMonitor watch;
  noticed_at(watch, 100, 12, 9);
  EXPECT_EQ(noticed_at(watch, 100, 12, 0), 4);
}

TEST(ExpectationMonitor, ThreeImagesInWhichTheyAreMissingMayBeBadOnes) {
  ExpectationMonitor watch;
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(noticed_at(watch, 10, 12, 9), 0);
    EXPECT_EQ(noticed_at(watch, 3, 12, 0), 0);
  }
}

TEST(ExpectationMonitor, FewExpectedLandmarksTellNothing) {
  ExpectationMonitor watch;
  EXPECT_EQ(noticed_at(watch, 100, 5, 0), 0);
}

TEST(ExpectationMonitor, StartsAgain) {
  ExpectationMonitor watch;
  EXPECT_EQ(noticed_at(watch, 100, 12, 0), 5);
  watch.start();
  EXPECT_EQ(noticed_at(watch, 4, 12, 0), 0);
}

}  // namespace
}  // namespace aisle
