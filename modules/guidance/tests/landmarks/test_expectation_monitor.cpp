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

/// @return number of the image at which kidnapping is detected; 0: at none
int noticed_at(ExpectationMonitor& monitor, int images, int all, int seen) {
  for (int i = 1; i <= images; ++i) {
    if (monitor.look(expected_of(all, seen))) return i;
  }
  return 0;
}

TEST(ExpectationMonitor, MostOfWhatShouldBeSeenMayBeMissing) {
  ExpectationMonitor monitor;
  EXPECT_EQ(noticed_at(monitor, 100, 10, 2), 0);
}

TEST(ExpectationMonitor, NoticesWithinTenImagesThatFewSeenLandmarksAreGone) {
  ExpectationMonitor monitor;
  noticed_at(monitor, 100, 12, 3);
  EXPECT_EQ(noticed_at(monitor, 100, 12, 0), 7);
}

TEST(ExpectationMonitor, NoticesWithinFourImagesThatManySeenLandmarksAreGone) {
  ExpectationMonitor monitor;
  noticed_at(monitor, 100, 12, 9);
  EXPECT_EQ(noticed_at(monitor, 100, 12, 0), 4);
}

TEST(ExpectationMonitor, ThreeImagesWithoutThemMayBeBadOnes) {
  ExpectationMonitor monitor;
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(noticed_at(monitor, 10, 12, 9), 0);
    EXPECT_EQ(noticed_at(monitor, 3, 12, 0), 0);
  }
}

TEST(ExpectationMonitor, FewExpectedLandmarksTellNothing) {
  ExpectationMonitor monitor;
  EXPECT_EQ(noticed_at(monitor, 100, 5, 0), 0);
}

TEST(ExpectationMonitor, StartsAgain) {
  ExpectationMonitor monitor;
  EXPECT_EQ(noticed_at(monitor, 100, 12, 0), 5);
  monitor.start();
  EXPECT_EQ(noticed_at(monitor, 4, 12, 0), 0);
}

}  // namespace
}  // namespace aisle
