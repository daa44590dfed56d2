#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "aisle/formats/worlds/vehicle_yaml.hpp"
#include "aisle/simulation/vehicle/simulated_vehicle.hpp"
#include "exploration/explorer_driver.hpp"

namespace aisle {
namespace {

constexpr double kTouchTimeMax_s = 900;
constexpr double kTouchAt_m = 3;  // where the vehicle's origin is when its front touches something

/// An L of two corridors, 1.4 m wide: along x for 6 m, then along y.
World corner_of_corridors() {
  World world;
  const Vec2 corners[] = {{0, 0}, {6, 0}, {6, 5}, {4.6, 5}, {4.6, 1.4}, {0, 1.4}};
  for (std::size_t i = 0; i < std::size(corners); ++i)
    world.walls.push_back({.foot = {corners[i], corners[(i + 1) % std::size(corners)]}});
  world.start = Pose2{1, 0.7, 0};
  return world;
}

TEST(ExplorerTouch, NotesWhatNoSliceShowsGoesNoFartherAndComesHomeWithoutACertificate) {
  auto model = read_vehicle(std::filesystem::path(AISLE_SOURCE_DIR) / "vehicles/alv-scanner.yaml");
  ASSERT_TRUE(model.ok());
  model->description.cameras.clear();
  const World world = corner_of_corridors();
  SimulatedVehicle vehicle(world, *model, {}, {.seed = 1, .T_world_start = *world.start});
  const auto explorer = make_explorer(explorer_origin({}, {}), model->description);
  ASSERT_TRUE(explorer.ok());

  Decision decision;
  int touches = 0;
  double farthest_m = 0;
  while (decision.status == NavigatorStatus::kGoing && vehicle.truth().stamp_s < kTouchTimeMax_s) {
    auto observation = *vehicle.sense();
    const double x_m = vehicle.truth().T_world_vehicle.x;
    observation.bumper_pressed = x_m > kTouchAt_m;
    decision = (*explorer)->step(observation);
    touches += decision.state == "touched" ? 1 : 0;
    farthest_m = std::max(farthest_m, x_m);
    vehicle.act(decision.command);
  }
  EXPECT_EQ(decision.status, NavigatorStatus::kDone) << decision.why;
  EXPECT_EQ(touches, 1);
  EXPECT_LT(farthest_m, kTouchAt_m + 0.1);
  EXPECT_FALSE((*explorer)->record().certified());
  EXPECT_TRUE((*explorer)->record().came_home);
  EXPECT_LT((vehicle.truth().T_world_vehicle.position() - world.start->position()).norm(), 0.1);
}

}  // namespace
}  // namespace aisle
