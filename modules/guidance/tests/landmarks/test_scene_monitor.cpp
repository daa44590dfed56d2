#include <gtest/gtest.h>

#include <vector>

#include "aisle/core/angle.hpp"
#include "aisle/guidance/landmarks/scene_monitor.hpp"

namespace aisle {
namespace {

constexpr double kStep_m = 0.03;

/// Doors on both sides, seen from a place along a corridor.
std::vector<LandmarkSighting> view(double along_m, double first_m = 0) {
  std::vector<LandmarkSighting> seen;
  for (int i = 0; i < 20; ++i) {
    const Vec2 p(first_m + 0.7 * i + 0.1 * (i * i % 5) - along_m, i % 2 == 0 ? 1 : -1);
    if (p.x() > 1 && p.x() < 6)
      seen.push_back({.p_vehicle = p, .covariance = Mat2::Identity() * 1e-4, .brighter_right = i % 3 == 0});
  }
  return seen;
}

/// Drives on and sees the doors. @return number of images in which kidnapping was detected
int drive(SceneMonitor& monitor, double from_m, int images, double first_m = 0) {
  int noticed = 0;
  for (int i = 0; i < images; ++i) {
    monitor.move({kStep_m, 0, 0});
    noticed += monitor.look(view(from_m + kStep_m * i, first_m)) ? 1 : 0;
  }
  return noticed;
}

TEST(SceneMonitor, DetectsNothingOnAPlainDrive) {
  SceneMonitor monitor;
  EXPECT_EQ(drive(monitor, 0, 200), 0);
}

TEST(SceneMonitor, DetectsKidnappingOnceAtTheSecondImage) {
  SceneMonitor monitor;
  drive(monitor, 0, 30);
  EXPECT_EQ(drive(monitor, 5, 1, 0.4), 0);
  EXPECT_EQ(drive(monitor, 5 + kStep_m, 1, 0.4), 1);
  EXPECT_EQ(drive(monitor, 5 + 2 * kStep_m, 50, 0.4), 0);
}

TEST(SceneMonitor, DoesNotMindOneBadImage) {
  SceneMonitor monitor;
  drive(monitor, 0, 30);
  EXPECT_FALSE(monitor.look(view(4, 0.37)));
  EXPECT_EQ(drive(monitor, 0.9, 50), 0);
}

TEST(SceneMonitor, TakesWhatIsKnownToBeHereForNoOtherPlace) {
  SceneMonitor monitor;
  drive(monitor, 0, 30);
  for (int i = 0; i < 3; ++i) EXPECT_FALSE(monitor.look(view(5, 0.4), true));
  EXPECT_EQ(drive(monitor, 5, 50, 0.4), 0);
}

TEST(SceneMonitor, DoesNotTakeDarknessForAnotherPlace) {
  SceneMonitor monitor;
  drive(monitor, 0, 30);
  for (int i = 0; i < 20; ++i) EXPECT_FALSE(monitor.look({}));
  EXPECT_EQ(drive(monitor, 0.9, 50), 0);
}

TEST(SceneMonitor, DoesNotCompareWithWhatItSawLongAgo) {
  SceneMonitor monitor;
  drive(monitor, 0, 30);
  for (int i = 0; i < 40; ++i) {
    monitor.move({kStep_m, 0, 0});
    EXPECT_FALSE(monitor.look({}));
  }
  EXPECT_EQ(drive(monitor, 5, 50, 0.4), 0);
}

TEST(SceneMonitor, DoesNotCompareWithWhatItSawBeforeItTurned) {
  SceneMonitor monitor;
  drive(monitor, 0, 30);
  for (int i = 0; i < 6; ++i) {
    monitor.move({kStep_m, 0, 2 * kDegree});
    EXPECT_FALSE(monitor.look({}));
  }
  EXPECT_EQ(drive(monitor, 5, 50, 0.4), 0);
}

TEST(SceneMonitor, DoesNotMindThatThingsAreLeftBehind) {
  SceneMonitor monitor;
  EXPECT_EQ(drive(monitor, 0, 700), 0);  // past the last door
}

}  // namespace
}  // namespace aisle
