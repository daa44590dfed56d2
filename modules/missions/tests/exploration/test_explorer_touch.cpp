#include <gtest/gtest.h>

#include <algorithm>

#include "explorer_run.hpp"

namespace aisle {
namespace {

constexpr double kContactTimeMax_s = 900;
constexpr double kContactAt_m = 3;  // where the vehicle's origin is when its front touches something

/// An L of two corridors, 1.4 m wide: along x for 6 m, then along y.
World corner_of_corridors() {
  return walled_by({{0, 0}, {6, 0}, {6, 5}, {4.6, 5}, {4.6, 1.4}, {0, 1.4}}, {1, 0.7, 0});
}

TEST(ExplorerTouch, RecordsAContactThatNoScanShowsGoesNoFartherAndComesHomeWithoutACertificate) {
  ExplorerRun run(corner_of_corridors(), 1);
  int contacts = 0;
  double farthest_m = 0;
  while (run.goes_on(kContactTimeMax_s)) {
    auto observation = *run.vehicle.sense();
    const double x_m = run.vehicle.truth().T_world_vehicle.x;
    observation.bumper_pressed = x_m > kContactAt_m;
    run.step(observation);
    contacts += run.last.state == "touched" ? 1 : 0;
    farthest_m = std::max(farthest_m, x_m);
  }
  EXPECT_EQ(run.last.status, NavigatorStatus::kDone) << run.last.why;
  EXPECT_EQ(contacts, 1);
  EXPECT_LT(farthest_m, kContactAt_m + 0.1);
  EXPECT_FALSE(run.explorer->record().certified());
  EXPECT_TRUE(run.explorer->record().came_home);
  EXPECT_LT(run.off_home_m(), 0.1);
}

/// A lobby, parted by a pane of glass with a passage beside it.
World lobby_with_glass(double returns) {
  World world = walled_by({{0, 0}, {12, 0}, {12, 6}, {0, 6}}, {2, 3, 0});
  world.walls.push_back({.floor_edge = {{6, 0}, {6, 3.5}}, .returns = returns});
  return world;
}

TEST(ExplorerTouch, GlassThatSendsBackATenthOfTheBeamsIsNotTouched) {
  ExplorerRun run(lobby_with_glass(0.1), 1);
  while (run.goes_on(kContactTimeMax_s)) run.step(*run.vehicle.sense());
  EXPECT_EQ(run.last.status, NavigatorStatus::kDone) << run.last.why;
  EXPECT_EQ(run.vehicle.truth().collisions, 0U);
  EXPECT_TRUE(run.explorer->record().certified());
}

TEST(ExplorerTouch, GlassThatNothingShowsCostsTheCertificate) {
  ExplorerRun run(lobby_with_glass(0), 1);
  while (run.goes_on(kContactTimeMax_s)) run.step(*run.vehicle.sense());
  EXPECT_GT(run.vehicle.truth().collisions, 0U);
  EXPECT_FALSE(run.explorer->record().certified());
}

}  // namespace
}  // namespace aisle
