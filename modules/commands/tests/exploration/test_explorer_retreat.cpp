#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "aisle/formats/worlds/vehicle_yaml.hpp"
#include "aisle/simulation/vehicle/simulated_vehicle.hpp"
#include "exploration/explorer_driver.hpp"

namespace aisle {
namespace {

constexpr double kTimeMax_s = 600;

/// A corridor along x, 8 m x 1.3 m, and on its left, behind a door that is open into it, a narrow room of
/// 1.5 m x 2.6 m, which is a dead end: the vehicle gets in, but a search in it finds no way out.
World corridor_with_narrow_room() {
  World world;
  const Vec2 corners[] = {{0, 0},      {8, 0},      {8, 1.3},   {4.92, 1.3}, {4.92, 2.4},
                          {4.96, 2.4}, {4.96, 1.5}, {5.1, 1.5}, {5.1, 4.1},  {3.58, 4.1},
                          {3.58, 1.5}, {4, 1.5},    {4, 1.3},   {0, 1.3}};
  for (std::size_t i = 0; i < std::size(corners); ++i)
    world.walls.push_back({.foot = {corners[i], corners[(i + 1) % std::size(corners)]}});
  world.start = Pose2{1, 0.65, 0};
  return world;
}

double off_m(const std::vector<Vec2>& way, const Vec2& p) {
  double least_m = 1e9;
  for (const Vec2& q : way) least_m = std::min(least_m, (p - q).norm());
  return least_m;
}

struct RoomTrip {
  Decision last;
  double back_m = 0;       ///< driven back along its trail
  double off_trail_m = 0;  ///< at most, meanwhile
  std::size_t collisions = 0;
  double off_home_m = 0;
};

RoomTrip drive_into_room(const World& world, const VehicleModel& model, std::uint64_t seed) {
  SimulatedVehicle vehicle(world, model, {}, {.seed = seed, .T_world_start = *world.start});
  const auto explorer = make_explorer(explorer_origin({}, {}), model.description);
  RoomTrip trip;
  if (!explorer) {
    ADD_FAILURE() << to_string(explorer.problems());
    return trip;
  }
  std::vector<Vec2> way_in;
  while (trip.last.status == NavigatorStatus::kGoing && vehicle.truth().stamp_s < kTimeMax_s) {
    const double way_m = vehicle.truth().way_m;
    trip.last = (*explorer)->step(*vehicle.sense());
    const Vec2 p_world = vehicle.truth().T_world_vehicle.position();
    if (trip.last.state == "retreating") {
      trip.back_m += vehicle.truth().way_m - way_m;
      trip.off_trail_m = std::max(trip.off_trail_m, off_m(way_in, p_world));
    } else {
      way_in.push_back(p_world);
    }
    vehicle.act(trip.last.command);
  }
  trip.collisions = vehicle.truth().collisions;
  trip.off_home_m = (vehicle.truth().T_world_vehicle.position() - world.start->position()).norm();
  return trip;
}

TEST(ExplorerRetreat, GoesBackAlongItsOwnTrailOutOfANarrowDeadEndAndThenHome) {
  constexpr std::uint64_t kSeeds = 30;
  auto model = read_vehicle(std::filesystem::path(AISLE_SOURCE_DIR) / "vehicles/alv-scanner.yaml");
  ASSERT_TRUE(model.ok());
  model->description.cameras.clear();
  const World world = corridor_with_narrow_room();
  int stuck = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    const RoomTrip trip = drive_into_room(world, *model, seed);
    EXPECT_EQ(trip.last.status, NavigatorStatus::kDone) << trip.last.why;
    EXPECT_LT(trip.off_trail_m, 0.1);
    EXPECT_EQ(trip.collisions, 0);
    EXPECT_LT(trip.off_home_m, 0.1);
    if (trip.back_m > 3) ++stuck;
  }
  EXPECT_GE(stuck, 5);  // others find a way out by themselves
}

}  // namespace
}  // namespace aisle
