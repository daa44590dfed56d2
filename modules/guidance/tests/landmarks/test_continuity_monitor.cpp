#include <gtest/gtest.h>

#include <vector>

#include "aisle/guidance/landmarks/continuity_monitor.hpp"

namespace aisle {
namespace {

constexpr double kDriven_m = 0.03;
constexpr double kNearest_m = 1.2;
const std::vector<LandmarkSighting> kBare;

/// Door edges on both sides of a corridor that begins bare, from 6 m on and up to 9 m.
std::vector<LandmarkSighting> doors_from(double along_m) {
  std::vector<LandmarkSighting> seen;
  for (int i = 0; i < 8; ++i) {
    const Vec2 p(6 + 0.4 * i - along_m, i % 2 == 0 ? 1 : -1);
    if (p.x() > 1.5 && p.x() < 6)
      seen.push_back({.p_vehicle = p, .covariance = Mat2::Identity() * 1e-4, .brighter_right = i % 3 == 0});
  }
  return seen;
}

bool drive_on(ContinuityMonitor& monitor, const std::vector<LandmarkSighting>& image,
              bool is_known_here = false) {
  monitor.move({kDriven_m, 0, 0});
  return monitor.look(image, is_known_here);
}

/// @return number of images in which kidnapping was detected
int drive_past(ContinuityMonitor& monitor, double from_m, int images) {
  int noticed = 0;
  for (int i = 0; i < images; ++i) noticed += drive_on(monitor, doors_from(from_m + kDriven_m * i)) ? 1 : 0;
  return noticed;
}

TEST(ContinuityMonitor, DrivingUpToDoorsAndPastThemGoesOn) {
  ContinuityMonitor monitor(kNearest_m);
  EXPECT_EQ(drive_past(monitor, 0, 400), 0);
}

/// Boards on a wall ahead, with nothing else in view, until its floor edge leaves the image below.
std::vector<LandmarkSighting> boards_on_wall(double ahead_m) {
  std::vector<LandmarkSighting> seen;
  for (int i = 0; i < 8 && ahead_m > kNearest_m; ++i)
    seen.push_back({.p_vehicle = {ahead_m, 0.2 * i - 0.7},
                    .covariance = Mat2::Identity() * 1e-4,
                    .brighter_right = i % 3 == 0});
  return seen;
}

TEST(ContinuityMonitor, DrivingUpToAWallAndBackingFromItGoesOn) {
  ContinuityMonitor monitor(kNearest_m);
  int noticed = 0;
  for (double ahead_m = 2; ahead_m > 0.5; ahead_m -= kDriven_m)
    noticed += drive_on(monitor, boards_on_wall(ahead_m)) ? 1 : 0;
  for (double ahead_m = 0.5; ahead_m < 2; ahead_m += kDriven_m) {
    monitor.move({-kDriven_m, 0, 0});
    noticed += monitor.look(boards_on_wall(ahead_m)) ? 1 : 0;
  }
  EXPECT_EQ(noticed, 0);
}

TEST(ContinuityMonitor, NoticesOnceThatTheWallAheadIsGone) {
  ContinuityMonitor monitor(kNearest_m);
  for (double ahead_m = 3; ahead_m > 2; ahead_m -= kDriven_m) drive_on(monitor, boards_on_wall(ahead_m));
  int noticed = 0;
  for (int i = 0; i < 50; ++i) noticed += monitor.look(kBare) ? 1 : 0;
  EXPECT_EQ(noticed, 1);
}

TEST(ContinuityMonitor, NoticesOnceThatDoorsNearbyAreGone) {
  ContinuityMonitor monitor(kNearest_m);
  drive_past(monitor, 3.5, 20);
  int noticed = 0;
  for (int i = 0; i < 50; ++i) noticed += drive_on(monitor, kBare) ? 1 : 0;
  EXPECT_EQ(noticed, 1);
}

/// Some images show distant lines, and later ones fewer of them.
/// @return number of images in which kidnapping was detected
int drive_towards_distant_lines(int images, std::size_t left) {
  ContinuityMonitor monitor(kNearest_m);
  std::vector<LandmarkSighting> distant;
  for (int i = 0; i < 9; ++i)
    distant.push_back({.p_vehicle = {5.5 + 0.3 * i, i % 2 == 0 ? 1 : -1},
                       .covariance = Mat2::Identity() * 1e-4,
                       .brighter_right = i % 3 == 0});
  drive_on(monitor, kBare);
  for (int i = 0; i < images; ++i) drive_on(monitor, distant);
  distant.resize(left);
  int noticed = 0;
  for (int i = 0; i < 10; ++i) noticed += drive_on(monitor, distant) ? 1 : 0;
  return noticed;
}

TEST(ContinuityMonitor, DistantLinesMayGoOneByOneButNotAllAtOnce) {
  EXPECT_EQ(drive_towards_distant_lines(2, 2), 0);
  EXPECT_EQ(drive_towards_distant_lines(2, 0), 1);
}

TEST(ContinuityMonitor, WhatOneImageAloneShowsNeedNotStay) {
  EXPECT_EQ(drive_towards_distant_lines(1, 0), 0);
}

TEST(ContinuityMonitor, NoticesOnceDoorsThatShouldHaveBeenInViewBefore) {
  ContinuityMonitor monitor(kNearest_m);
  for (int i = 0; i < 20; ++i) EXPECT_FALSE(drive_on(monitor, kBare));
  EXPECT_EQ(drive_past(monitor, 3.5, 50), 1);
}

TEST(ContinuityMonitor, AFewBadImagesAreNoOtherPlace) {
  ContinuityMonitor monitor(kNearest_m);
  drive_past(monitor, 3.5, 20);
  for (int i = 0; i < 3; ++i) EXPECT_FALSE(drive_on(monitor, kBare));
  EXPECT_EQ(drive_past(monitor, 3.5 + 23 * kDriven_m, 50), 0);
}

TEST(ContinuityMonitor, LinesThatDoNotStayAreNoOtherPlace) {
  ContinuityMonitor monitor(kNearest_m);
  for (int i = 0; i < 20; ++i) drive_on(monitor, kBare);
  for (int i = 0; i < 20; ++i) EXPECT_FALSE(drive_on(monitor, doors_from(i % 2 == 0 ? 3.5 : 3.7)));
}

TEST(ContinuityMonitor, WhatIsKnownToBeHereIsNoOtherPlace) {
  ContinuityMonitor monitor(kNearest_m);
  for (int i = 0; i < 20; ++i) drive_on(monitor, kBare);
  for (int i = 0; i < 20; ++i) EXPECT_FALSE(drive_on(monitor, doors_from(3.5 + kDriven_m * i), true));
}

TEST(ContinuityMonitor, AFewLinesMayComeAndGo) {
  ContinuityMonitor monitor(kNearest_m);
  const std::vector<LandmarkSighting> doors = doors_from(4);
  const std::vector<LandmarkSighting> some(doors.begin(), doors.begin() + 4);
  for (int i = 0; i < 50; ++i) EXPECT_FALSE(drive_on(monitor, i / 10 % 2 == 0 ? kBare : some));
}

}  // namespace
}  // namespace aisle
