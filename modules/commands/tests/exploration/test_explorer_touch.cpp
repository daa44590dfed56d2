#include <gtest/gtest.h>

#include <algorithm>

#include "explorer_trip.hpp"

namespace aisle {
namespace {

constexpr double kTouchTimeMax_s = 900;
constexpr double kTouchAt_m = 3;  // where the vehicle's origin is when its front touches something

/// An L of two corridors, 1.4 m wide: along x for 6 m, then along y.
World corner_of_corridors() {
  return walled_by({{0, 0}, {6, 0}, {6, 5}, {4.6, 5}, {4.6, 1.4}, {0, 1.4}}, {1, 0.7, 0});
}

TEST(ExplorerTouch, NotesWhatNoSliceShowsGoesNoFartherAndComesHomeWithoutACertificate) {
  ExplorerTrip trip(corner_of_corridors(), 1);
  int touches = 0;
  double farthest_m = 0;
  while (trip.goes_on(kTouchTimeMax_s)) {
    auto observation = *trip.vehicle.sense();
    const double x_m = trip.vehicle.truth().T_world_vehicle.x;
    observation.bumper_pressed = x_m > kTouchAt_m;
    trip.step(observation);
    touches += trip.last.state == "touched" ? 1 : 0;
    farthest_m = std::max(farthest_m, x_m);
  }
  EXPECT_EQ(trip.last.status, NavigatorStatus::kDone) << trip.last.why;
  EXPECT_EQ(touches, 1);
  EXPECT_LT(farthest_m, kTouchAt_m + 0.1);
  EXPECT_FALSE(trip.explorer->record().certified());
  EXPECT_TRUE(trip.explorer->record().came_home);
  EXPECT_LT(trip.off_home_m(), 0.1);
}

}  // namespace
}  // namespace aisle
