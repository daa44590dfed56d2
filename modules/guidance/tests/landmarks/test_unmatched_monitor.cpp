#include <gtest/gtest.h>

#include <vector>

#include "aisle/guidance/landmarks/unmatched_monitor.hpp"
#include "corridor_run.hpp"

namespace aisle {
namespace {

constexpr int kLeast = 3;

/// A camera 0.85 m before the rear axle and 1 m high, 65 degrees wide, tilted down.
CameraDescription corridor_camera_of_cart() {
  CameraDescription camera;
  camera.mount = {.p_vehicle_camera = {0.85, 0, 1}, .tilt_rad = 14 * kDegree};
  return camera;
}

/// The view of a route taught from (0, 0) to (10, 0).
TaughtView taught_view() {
  TaughtView view(FloorInImage{corridor_camera_of_cart()});
  view.add(Path({PathPiece{{0, 0, 0}, {10, 0}}}));
  return view;
}

/// Unknown lines on both sides ahead of the vehicle.
std::vector<LandmarkSighting> unknown_things() {
  std::vector<LandmarkSighting> image;
  for (const double x : {2.5, 3.0, 3.5, 4.0}) {
    for (const double y : {1.0, -1.0}) image.push_back(sighting_of({x, y}, false, {}));
  }
  return image;
}

TEST(TaughtView, ShowsWhatWasBeforeTheVehicleOnItsPath) {
  TaughtView view = taught_view();
  EXPECT_TRUE(view.shows({5, 1}));
  EXPECT_TRUE(view.shows({14, -1})) << "4 m beyond the end";
  EXPECT_FALSE(view.shows({18, 0})) << "8 m beyond it";
  EXPECT_FALSE(view.shows({-2, 0})) << "behind the start";
  EXPECT_FALSE(view.shows({1.5, 1})) << "57 degrees beside the lens at the start";
  EXPECT_FALSE(view.shows({5, 6})) << "at most 4.6 m to the side at 7 m";
}

TEST(TaughtView, OfNoRouteShowsNothing) {
  TaughtView view(FloorInImage{corridor_camera_of_cart()});
  EXPECT_FALSE(view.shows({5, 1}));
}

TEST(UnmatchedMonitor, CountsThePathWithUnknownLinesInsideTheTaughtView) {
  UnmatchedMonitor monitor(taught_view(), kLeast);
  for (int i = 0; i < 10; ++i) monitor.look(unknown_things(), false, {1 + 0.1 * i, 0, 0}, 0.1);
  EXPECT_TRUE(monitor.is_unmatched());
  EXPECT_NEAR(monitor.path_m(), 1, 1e-9);
}

TEST(UnmatchedMonitor, NothingIsUnmatchedBeyondTheRoutesStartOnTheReturnPath) {
  UnmatchedMonitor monitor(taught_view(), kLeast);
  for (int i = 0; i < 20; ++i) monitor.look(unknown_things(), false, {4 - 0.1 * i, 0, kPi}, 0.1);
  EXPECT_FALSE(monitor.is_unmatched());
  EXPECT_EQ(monitor.path_m(), 0);
}

TEST(UnmatchedMonitor, FewUnknownThingsAreNotUnmatched) {
  UnmatchedMonitor monitor(taught_view(), kLeast);
  const std::vector<LandmarkSighting> two(2, sighting_of({3, 1}, false, {}));
  monitor.look(two, false, {2, 0, 0}, 0.1);
  EXPECT_FALSE(monitor.is_unmatched());
  EXPECT_EQ(monitor.path_m(), 0);
}

TEST(UnmatchedMonitor, AnImageThatFitsHalvesThePath) {
  UnmatchedMonitor monitor(taught_view(), kLeast);
  monitor.look(unknown_things(), false, {2, 0, 0}, 2);
  monitor.look(unknown_things(), true, {2.1, 0, 0}, 0.1);
  EXPECT_FALSE(monitor.is_unmatched());
  EXPECT_EQ(monitor.path_m(), 1);
}

TEST(UnmatchedMonitor, BeginsAgain) {
  UnmatchedMonitor monitor(taught_view(), kLeast);
  monitor.look(unknown_things(), false, {2, 0, 0}, 2);
  monitor.start();
  EXPECT_FALSE(monitor.is_unmatched());
  EXPECT_EQ(monitor.path_m(), 0);
}

}  // namespace
}  // namespace aisle
