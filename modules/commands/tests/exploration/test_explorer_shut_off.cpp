#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "aisle/formats/worlds/vehicle_yaml.hpp"
#include "aisle/simulation/vehicle/simulated_vehicle.hpp"
#include "exploration/explorer_driver.hpp"

namespace aisle {
namespace {

/// A hall of 10 m x 10 m, in which a search does not try all poses; off it a dead end, 1 m wide, and off that
/// a room. Its door is 0.95 m wide and opens 0.26 m before the end: the vehicle cannot swing in.
World hall_with_a_room_that_is_shut_off() {
  World world;
  const Vec2 corners[] = {{0, 0},        {10, 0},      {10, 10},   {0, 10},  {0, 5.33},  {-5.79, 5.33},
                          {-5.79, 5.46}, {-4.5, 5.46}, {-4.5, 8},  {-7, 8},  {-7, 5.46}, {-6.74, 5.46},
                          {-6.74, 5.33}, {-7, 5.33},   {-7, 4.33}, {0, 4.33}};
  for (std::size_t i = 0; i < std::size(corners); ++i)
    world.walls.push_back({.foot = {corners[i], corners[(i + 1) % std::size(corners)]}});
  world.start = Pose2{5, 4.7, kPi};
  return world;
}

TEST(ExplorerShutOff, GivesUpARoomThatItCannotSwingInto) {
  auto model = read_vehicle(std::filesystem::path(AISLE_SOURCE_DIR) / "vehicles/alv-scanner.yaml");
  ASSERT_TRUE(model.ok());
  model->description.cameras.clear();
  const World world = hall_with_a_room_that_is_shut_off();
  SimulatedVehicle vehicle(world, *model, {}, {.seed = 1, .T_world_start = *world.start});
  const auto explorer = make_explorer(explorer_origin({}, {}), model->description);
  ASSERT_TRUE(explorer.ok());

  constexpr double kLate_s = 600;
  Decision decision;
  while (decision.status == NavigatorStatus::kGoing && vehicle.truth().stamp_s < kLate_s) {
    decision = (*explorer)->step(*vehicle.sense());
    vehicle.act(decision.command);
  }
  EXPECT_EQ(decision.status, NavigatorStatus::kDone);
  EXPECT_EQ(decision.why, "explored");
  EXPECT_EQ(vehicle.truth().collisions, 0);
  const auto events = (*explorer)->record().paths;
  EXPECT_TRUE(std::any_of(events.begin(), events.end(),
                          [](const PathEvent& event) { return event.kind == PathEvent::Kind::kGivenUp; }));
}

}  // namespace
}  // namespace aisle
