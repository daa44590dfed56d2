#include <gmock/gmock.h>

#include "aisle/simulation/operators/scripted_operator.hpp"
#include "aisle/simulation/vehicle/simulated_vehicle.hpp"
#include "operators/operator_path.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;
using testing::Field;

VehicleModel guided_cart() {
  VehicleModel model;
  model.description.front_steered.wheelbase_m = 0.75;
  model.description.footprint = {.front_m = 0.95, .rear_m = 0.25, .width_m = 0.6, .height_m = 1.2};
  return model;
}

VehicleModel guided_mini() {
  VehicleModel model;
  model.description.is_differential = true;
  model.description.footprint = {.front_m = 0.11, .rear_m = 0.11, .width_m = 0.2, .height_m = 0.25};
  return model;
}

/// An L of corridors 2.4 m wide.
World corner() {
  World world{.name = "corner"};
  const std::vector<Vec2> line = {{-2, -1.2}, {11.2, -1.2}, {11.2, 10}, {8.8, 10},
                                  {8.8, 1.2}, {-2, 1.2},    {-2, -1.2}};
  for (std::size_t i = 1; i < line.size(); ++i) world.walls.push_back({.floor_edge = {line[i - 1], line[i]}});
  world.tour = {{0, 0}, {10, 0}, {10, 8}};
  world.places = {{"door", {5, 0.2, 0}}, {"yard", {50, 50, 0}}};
  return world;
}

/// A corridor along x, and one 1.2 m wide that leads off it to the left.
World narrow_tee(double from_x, double to_x, double half_width) {
  World world{.name = "narrow tee"};
  const std::vector<Vec2> line = {{from_x, -half_width},
                                  {to_x, -half_width},
                                  {to_x, half_width},
                                  {0.6, half_width},
                                  {0.6, 9},
                                  {-0.6, 9},
                                  {-0.6, half_width},
                                  {from_x, half_width},
                                  {from_x, -half_width}};
  for (std::size_t i = 1; i < line.size(); ++i) world.walls.push_back({.floor_edge = {line[i - 1], line[i]}});
  world.tour = {{-3, 0}, {0, 0}, {0, 7}};
  return world;
}

/// From a corridor 2.4 m wide into one of 1.2 m, a bit back out of it, and on along the first one.
World narrow_dead_end() {
  World world = narrow_tee(-8, 12, 1.2);
  world.tour = {{-6, 0}, {0, 0}, {0, 6}, {0, 0}, {9, 0}};
  return world;
}

struct Drive {
  Truth end;
  std::vector<Mark> marks;
  bool came_near = false;    ///< within 3 cm of a wall
  double largest_off_m = 0;  ///< lateral offset in the first 8 m of the first corridor
  bool arrived = false;
  bool gave_up = false;
};

Drive drive(const World& world, const VehicleModel& model, std::uint64_t seed,
            const Scenario& scenario = {}) {
  ScriptedOperator person(world, model.description, {}, seed);
  SimulatedVehicle vehicle(world, model, scenario,
                           {.seed = seed, .T_world_start = *start_pose(world), .takes_images = false},
                           &person);
  Obstacles near_walls(world, with_clearance(model.description.footprint, 0.03));
  Drive drive;
  for (int i = 0; i < 6000; ++i) {
    const Observation observation = *vehicle.sense();
    const OperatorInput& input = observation.operator_input;
    drive.marks.insert(drive.marks.end(), input.marks.begin(), input.marks.end());
    drive.came_near |= near_walls.touch(vehicle.truth().T_world_vehicle);
    if (vehicle.truth().T_world_vehicle.x < 8) {
      drive.largest_off_m = std::max(drive.largest_off_m, std::abs(vehicle.truth().T_world_vehicle.y));
    }
    drive.gave_up = input.gives_up;
    if (input.quit) break;
    vehicle.act(input.requested.value_or(Command{}));
  }
  drive.end = vehicle.truth();
  drive.arrived = person.has_arrived();
  return drive;
}

class ScriptedOperatorTest : public testing::TestWithParam<bool> {
 protected:
  void expect_to_get_through(const World& world) const {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      const Drive run = drive(world, model, seed);
      EXPECT_TRUE(run.arrived) << seed;
      EXPECT_EQ(run.end.collisions, 0U) << seed;
    }
  }

  const VehicleModel model = GetParam() ? guided_mini() : guided_cart();
};

TEST_P(ScriptedOperatorTest, DrivesRoundACornerToTheEndOfTheRoute) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Drive run = drive(corner(), model, seed);
    EXPECT_TRUE(run.arrived) << seed;
    EXPECT_EQ(run.end.collisions, 0U) << seed;
    EXPECT_THAT(run.end.T_world_vehicle, PoseNear(Pose2{10, 8, kPi / 2}, 0.3, 0.2)) << seed;
  }
}

TEST_P(ScriptedOperatorTest, WandersLikeAPersonAndEachPersonOtherwise) {
  const Drive one = drive(corner(), model, 1), same = drive(corner(), model, 1),
              other = drive(corner(), model, 2);
  EXPECT_GT(one.largest_off_m, 0.01);
  EXPECT_LT(one.largest_off_m, 0.25);
  EXPECT_THAT(one.end.T_world_vehicle, PoseNear(same.end.T_world_vehicle, 0, 0));
  EXPECT_NE(one.end.T_world_vehicle.x, other.end.T_world_vehicle.x);
}

TEST_P(ScriptedOperatorTest, NamesThePlacesThatItPassesAndTheEnd) {
  EXPECT_THAT(drive(corner(), model, 3).marks,
              ElementsAre(Mark{Mark::Kind::kPlace, "door"}, Mark{Mark::Kind::kStop, ""}));
}

TEST_P(ScriptedOperatorTest, ComesBackWhereTheRouteTurnsBack) {
  World world = corner();
  world.tour = {{0, 0}, {6, 0}, {1, 0}};
  const Drive run = drive(world, model, 4);
  EXPECT_TRUE(run.arrived);
  EXPECT_EQ(run.end.collisions, 0U);
  const double heading_rad = model.description.is_differential ? kPi : 0;
  EXPECT_THAT(run.end.T_world_vehicle, PoseNear(Pose2{1, 0, heading_rad}, 0.3, 0.3));
}

TEST_P(ScriptedOperatorTest, WhereTheRouteBackTurnsOffItBacksRoundTheCornerAndGoesOnForwards) {
  // Into the side corridor, a bit back out of it, and on along the first one.
  World world{.name = "tee"};
  const std::vector<Vec2> line = {{-8, -1.2}, {12, -1.2},  {12, 1.2}, {1.2, 1.2}, {1.2, 9},
                                  {-1.2, 9},  {-1.2, 1.2}, {-8, 1.2}, {-8, -1.2}};
  for (std::size_t i = 1; i < line.size(); ++i) world.walls.push_back({.floor_edge = {line[i - 1], line[i]}});
  world.tour = {{-6, 0}, {0, 0}, {0, 6}, {0, 0}, {9, 0}};
  const Drive run = drive(world, model, 6);
  EXPECT_TRUE(run.arrived);
  EXPECT_EQ(run.end.collisions, 0U);
  EXPECT_THAT(run.end.T_world_vehicle, PoseNear(Pose2{9, 0, 0}, 0.3, 0.3));
}

TEST_P(ScriptedOperatorTest, TurnsIntoANarrowCorridorSoThatTheOuterFrontCornerGetsThrough) {
  expect_to_get_through(narrow_tee(-4, 6, 1));
}

TEST_P(ScriptedOperatorTest, SteersClearOfTheCornersOfANarrowCorridorForwardsAndBackwards) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Drive run = drive(narrow_dead_end(), model, seed);
    EXPECT_TRUE(run.arrived) << seed;
    EXPECT_FALSE(run.came_near) << seed;
  }
}

TEST_P(ScriptedOperatorTest, BacksOffFromAWallThatItCameTooNearToAndComesAgain) {
  // So narrow that three in ten come too near to the wall in the bend.
  expect_to_get_through(narrow_tee(-4, 4, 0.62));
}

TEST_P(ScriptedOperatorTest, GivesUpBeforeABoxThatStays) {
  const Scenario blocked{.events = {{.fault = BlockingBox{.T_world_box = {6, 0, 0}, .size = {0.5, 2.3}}}}};
  const Drive run = drive(corner(), model, 5, blocked);
  EXPECT_FALSE(run.arrived);
  EXPECT_TRUE(run.gave_up);
  EXPECT_EQ(run.end.collisions, 0U);
}

INSTANTIATE_TEST_SUITE_P(Vehicles, ScriptedOperatorTest, testing::Bool(),
                         [](const auto& vehicle) { return vehicle.param ? "Differential" : "FrontSteered"; });

}  // namespace
}  // namespace aisle
