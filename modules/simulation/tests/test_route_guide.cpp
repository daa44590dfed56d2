#include "aisle/simulation/route_guide.hpp"

#include <gmock/gmock.h>

#include "aisle/guidance/hand_driver.hpp"
#include "aisle/simulation/simulated_vehicle.hpp"

namespace aisle {
namespace {

/// An L of two legs in the open, with one turning.
World open_floor() {
  World world;
  world.routes = {{.name = "way", .parking = ParkingStrategy::kDeadEnd, .way = {{0, 0}, {4, 0}, {4, 4}}}};
  world.turnings = {{.route = "way", .number = 1, .at = {4, 0}, .before_m = 1.5, .after_m = 1},
                    {.route = "other", .number = 2, .at = {1, 0}}};
  return world;
}

/// What a person said, and where, who drove the world's first route to its end.
struct GuidedDrive {
  std::vector<Mark> marks;
  std::vector<Vec2> places;
};

GuidedDrive driven_with_marks(const World& world) {
  const VehicleModel model;
  RouteGuide person(world, world.routes.front(), model.description, {}, 1);
  SimulatedVehicle vehicle(
      world, model, {}, {.T_world_start = start_of(world.routes.front()), .takes_pictures = false}, &person);
  HandDriver driver({});
  GuidedDrive drive;
  for (int cycle = 0; cycle < 1000; ++cycle) {
    const auto observation = vehicle.sense();
    if (!observation) break;
    for (const Mark& mark : observation->operator_input.marks) {
      drive.marks.push_back(mark);
      drive.places.push_back(vehicle.truth().T_world_vehicle.position());
    }
    const Decision decision = driver.step(*observation);
    if (decision.status != NavigatorStatus::kGoing) break;
    vehicle.act(decision.command);
  }
  EXPECT_TRUE(person.has_arrived());
  return drive;
}

TEST(RouteGuide, SaysWhereTurningsBeginAndEndAndHowToPark) {
  const auto [marks, places] = driven_with_marks(open_floor());
  EXPECT_THAT(marks,
              testing::ElementsAre(Mark{Mark::Kind::kTurningBegins, "1"}, Mark{Mark::Kind::kTurningEnds, "1"},
                                   Mark{Mark::Kind::kStop, "dead-end"}));
  ASSERT_EQ(places.size(), 3U);
  EXPECT_NEAR(places[0].x(), 2.5, 0.15);
  EXPECT_NEAR(places[1].y(), 1, 0.2);
  EXPECT_NEAR(places[2].y(), 4, 0.3);
}

TEST(RouteGuide, BetweenCloseTurningsItBacksAfterTheEndOfTheFirst) {
  World world;
  world.routes = {{.name = "way", .way = {{0, 0}, {4, 0}, {1, 0}, {3, 0}, {3, 4}}}};
  world.turnings = {{.route = "way", .number = 4, .at = {2, 0}, .before_m = 1, .after_m = 2},
                    {.route = "way", .number = 7, .at = {3, 0.3}, .before_m = 2.3, .after_m = 1}};
  const auto driven = driven_with_marks(world);
  ASSERT_EQ(driven.marks.size(), 5U);
  EXPECT_EQ(driven.marks[1], (Mark{Mark::Kind::kTurningEnds, "4"}));
  EXPECT_NEAR(driven.places[1].x(), 4, 0.3);
  EXPECT_EQ(driven.marks[2], (Mark{Mark::Kind::kTurningBegins, "7"}));
  EXPECT_NEAR(driven.places[2].x(), 1, 0.3);
}

TEST(RouteGuide, RoutesAreFoundByName) {
  const World world = open_floor();
  EXPECT_EQ(route_of(world, "way"), world.routes.data());
  EXPECT_EQ(route_of(world, "no way"), nullptr);
}

}  // namespace
}  // namespace aisle
