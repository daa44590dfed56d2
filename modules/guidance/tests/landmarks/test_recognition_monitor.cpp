#include "aisle/guidance/landmarks/recognition_monitor.hpp"

#include <gtest/gtest.h>

namespace aisle {
namespace {

constexpr Pose2 kStep{0.03, 0, 0};

/// Drives on for a number of images.
/// @return number of the image at which kidnapping is detected; 0: at none
int noticed_at(RecognitionMonitor& monitor, int images, std::size_t sightings, std::size_t pairs,
               bool is_known_here, const Pose2& step = kStep) {
  for (int i = 1; i <= images; ++i) {
    monitor.move(step);
    if (monitor.look(sightings, pairs, is_known_here)) return i;
  }
  return 0;
}

TEST(RecognitionMonitor, NoticesWithinFiveImagesThatNothingIsKnownAnyMore) {
  RecognitionMonitor monitor;
  EXPECT_EQ(noticed_at(monitor, 30, 9, 8, true), 0);
  EXPECT_EQ(noticed_at(monitor, 20, 5, 0, false), 5);
}

TEST(RecognitionMonitor, ChancePairsDoNotHideIt) {
  RecognitionMonitor monitor;
  noticed_at(monitor, 30, 9, 8, true);
  EXPECT_EQ(noticed_at(monitor, 20, 6, 1, false), 5);
}

TEST(RecognitionMonitor, AMapThatEndsLineByLineIsNoKidnapping) {
  RecognitionMonitor monitor;
  noticed_at(monitor, 30, 9, 8, true);
  for (std::size_t pairs = 6; pairs > 0; --pairs)
    ASSERT_EQ(noticed_at(monitor, 3, 9, pairs, false), 0) << pairs << " pairs";
  EXPECT_EQ(noticed_at(monitor, 50, 9, 0, false), 0);
}

TEST(RecognitionMonitor, ImagesThatShowLittleTellNothing) {
  RecognitionMonitor monitor;
  noticed_at(monitor, 30, 9, 8, true);
  EXPECT_EQ(noticed_at(monitor, 50, 0, 0, false), 0);
}

TEST(RecognitionMonitor, AfterATurnOtherThingsAreInView) {
  RecognitionMonitor monitor;
  noticed_at(monitor, 30, 9, 8, true);
  EXPECT_EQ(noticed_at(monitor, 20, 9, 0, false, {0.03, 0, 3 * kDegree}), 0);
}

TEST(RecognitionMonitor, WhatWasKnownByChanceTellsNothing) {
  RecognitionMonitor monitor;
  noticed_at(monitor, 30, 9, 3, false);
  noticed_at(monitor, 3, 9, 8, true);
  EXPECT_EQ(noticed_at(monitor, 20, 9, 0, false), 0);
}

TEST(RecognitionMonitor, StartsAgain) {
  RecognitionMonitor monitor;
  noticed_at(monitor, 30, 9, 8, true);
  monitor.start();
  EXPECT_EQ(noticed_at(monitor, 20, 9, 0, false), 0);
}

}  // namespace
}  // namespace aisle
