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

/// Drives on by odometry and sees what there is. @return in how many images it was noticed
int drive(SceneMonitor& watch, double from_m, int images, double first_m = 0) {
  int noticed = 0;
  for (int i = 0; i < images; ++i) {
    watch.move({kStep_m, 0, 0});
    noticed += watch.look(view(from_m + kStep_m * i, first_m)) ? 1 : 0;
  }
  return noticed;
}

TEST(SceneMonitor, SeesNothingUnmatchedInADrive) {
  SceneMonitor watch;
  EXPECT_EQ(drive(watch, 0, 200), 0);
}

TEST(SceneMonitor, NoticesAtTheSecondImageThatItWasPutElsewhereAndNoticesItOnce) {
  SceneMonitor watch;
  drive(watch, 0, 30);
  EXPECT_EQ(drive(watch, 5, 1, 0.4), 0);
  EXPECT_EQ(drive(watch, 5 + kStep_m, 1, 0.4), 1);
  EXPECT_EQ(drive(watch, 5 + 2 * kStep_m, 50, 0.4), 0);
}

TEST(SceneMonitor, DoesNotMindOneBadImage) {
  SceneMonitor watch;
  drive(watch, 0, 30);
  EXPECT_FALSE(watch.look(view(4, 0.37)));
  EXPECT_EQ(drive(watch, 0.9, 50), 0);
}

TEST(SceneMonitor, TakesWhatIsKnownToBeHereForNoOtherPlace) {
  SceneMonitor watch;
  drive(watch, 0, 30);
  for (int i = 0; i < 3; ++i) EXPECT_FALSE(watch.look(view(5, 0.4), true));
  EXPECT_EQ(drive(watch, 5, 50, 0.4), 0);
}

TEST(SceneMonitor, DoesNotTakeDarknessForAnotherPlace) {
  SceneMonitor watch;
  drive(watch, 0, 30);
  for (int i = 0; i < 20; ++i) EXPECT_FALSE(watch.look({}));
  EXPECT_EQ(drive(watch, 0.9, 50), 0);
}

TEST(SceneMonitor, DoesNotCompareWithWhatItSawLongAgo) {
  SceneMonitor watch;
  drive(watch, 0, 30);
  for (int i = 0; i < 40; ++i) {
    watch.move({kStep_m, 0, 0});
    EXPECT_FALSE(watch.look({}));
  }
  EXPECT_EQ(drive(watch, 5, 50, 0.4), 0);
}

TEST(SceneMonitor, DoesNotCompareWithWhatItSawBeforeItTurned) {
  SceneMonitor watch;
  drive(watch, 0, 30);
  for (int i = 0; i < 6; ++i) {
    watch.move({kStep_m, 0, 2 * kDegree});
    EXPECT_FALSE(watch.look({}));
  }
  EXPECT_EQ(drive(watch, 5, 50, 0.4), 0);
}

TEST(SceneMonitor, DoesNotMindThatThingsAreLeftBehind) {
  SceneMonitor watch;
  EXPECT_EQ(drive(watch, 0, 700), 0);  // past the last door
}

}  // namespace
}  // namespace aisle
