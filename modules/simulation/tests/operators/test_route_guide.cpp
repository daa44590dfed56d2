#include "aisle/simulation/operators/route_guide.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "aisle/core/angle.hpp"
#include "aisle/guidance/hand_driver.hpp"
#include "aisle/maps/view_pattern.hpp"
#include "aisle/simulation/vehicle/simulated_vehicle.hpp"

namespace aisle {
namespace {

/// An L of two legs in the open, with one turning.
World open_floor() {
  World world;
  world.routes = {{.name = "bend", .parking = ParkingStrategy::kDeadEnd, .path = {{0, 0}, {4, 0}, {4, 4}}}};
  world.turnings = {{.route = "bend", .number = 1, .at = {4, 0}, .before_m = 1.5, .after_m = 1},
                    {.route = "other", .number = 2, .at = {1, 0}}};
  return world;
}

/// The marks that a person gave, and where, while driving the world's first route to its end.
struct GuidedDrive {
  std::vector<Mark> marks;
  std::vector<Vec2> places;
  std::vector<Pose2> T_world_forwards;  ///< where it drove forwards after its last mark
};

GuidedDrive driven_with_marks(const World& world, ShownViews views = ShownViews::kTrail) {
  const VehicleModel model;
  RouteGuide person(world, world.routes.front(), model.description, {}, 1, views);
  SimulatedVehicle vehicle(world, model, {},
                           {.T_world_start = start_of(world.routes.front()), .takes_images = false}, &person);
  HandDriver driver({});
  GuidedDrive drive;
  for (int cycle = 0; cycle < 10'000; ++cycle) {
    const auto observation = vehicle.sense();
    if (!observation) break;
    for (const Mark& mark : observation->operator_input.marks) {
      drive.marks.push_back(mark);
      drive.places.push_back(vehicle.truth().T_world_vehicle.position());
      drive.T_world_forwards.clear();
    }
    if (vehicle.truth().speed_mps > 0) drive.T_world_forwards.push_back(vehicle.truth().T_world_vehicle);
    const Decision decision = driver.step(*observation);
    if (decision.status != NavigatorStatus::kGoing) break;
    vehicle.act(decision.command);
  }
  EXPECT_TRUE(person.has_arrived());
  return drive;
}

TEST(RouteGuide, SaysWhereTurningsBeginAndEndAndHowToPark) {
  const auto [marks, places, T_world_forwards] = driven_with_marks(open_floor());
  EXPECT_THAT(marks,
              testing::ElementsAre(Mark{Mark::Kind::kTurningBegins, "1"}, Mark{Mark::Kind::kTurningEnds, "1"},
                                   Mark{Mark::Kind::kStop, "dead-end"}));
  ASSERT_EQ(places.size(), 3U);
  EXPECT_NEAR(places[0].x(), 2.5, 0.15);
  EXPECT_NEAR(places[1].y(), 1, 0.2);
  EXPECT_NEAR(places[2].y(), 4, 0.3);
}

TEST(RouteGuide, BetweenCloseTurningsItReversesAfterTheEndOfTheFirst) {
  World world;
  world.routes = {{.name = "bend", .path = {{0, 0}, {4, 0}, {1, 0}, {3, 0}, {3, 4}}}};
  world.turnings = {{.route = "bend", .number = 4, .at = {2, 0}, .before_m = 1, .after_m = 2},
                    {.route = "bend", .number = 7, .at = {3, 0.3}, .before_m = 2.3, .after_m = 1}};
  const auto driven = driven_with_marks(world);
  ASSERT_EQ(driven.marks.size(), 5U);
  EXPECT_EQ(driven.marks[1], (Mark{Mark::Kind::kTurningEnds, "4"}));
  EXPECT_NEAR(driven.places[1].x(), 4, 0.3);
  EXPECT_EQ(driven.marks[2], (Mark{Mark::Kind::kTurningBegins, "7"}));
  EXPECT_NEAR(driven.places[2].x(), 1, 0.3);
}

/// Distance of a pose from the nearest driven one that is turned by at most 3 degrees.
double nearest_m(const std::vector<Pose2>& driven, const Pose2& T_world_wished) {
  double least_m = 100;
  for (const Pose2& T_world_vehicle : driven) {
    const Pose2 off = between(T_world_wished, T_world_vehicle);
    if (std::abs(off.theta) < 3 * kDegree) least_m = std::min(least_m, off.position().norm());
  }
  return least_m;
}

TEST(RouteGuide, ShowsViewsFromAboutATaughtPlace) {
  World world;
  world.routes = {{.name = "bend", .parking = ParkingStrategy::kView, .path = {{0, 0}, {4, 0}}}};
  const GuidedDrive driven = driven_with_marks(world, ShownViews::kPattern);
  ASSERT_EQ(driven.marks, std::vector(1, Mark{Mark::Kind::kStop, "view"})) << "the route ends before them";
  const Pose2 T_world_place{driven.places.front().x(), driven.places.front().y(), 0};
  int passed = 0;
  for (const ViewLane& lane : view_pattern())
    for (const double along_m : lane.along_m)
      passed += nearest_m(driven.T_world_forwards, T_world_place * lane.at(along_m)) < 0.06 ? 1 : 0;
  EXPECT_GE(passed, 50) << "of 63; hands are not exact";
}

TEST(RouteGuide, LeavesOutLanesWithoutClearance) {
  World world;
  world.routes = {{.name = "bend", .parking = ParkingStrategy::kView, .path = {{0, 0}, {4, 0}}}};
  world.furniture = {{.centre = {3, -0.6}, .size = {4, 0.3}, .height_m = 1}};  // 15 cm beside the vehicle
  const GuidedDrive driven = driven_with_marks(world, ShownViews::kPattern);
  double right_m = 0, left_m = 0;
  for (const Pose2& T_world_vehicle : driven.T_world_forwards) {
    right_m = std::max(right_m, -T_world_vehicle.y);
    left_m = std::max(left_m, T_world_vehicle.y);
  }
  EXPECT_LT(right_m, 0.15);
  EXPECT_GT(left_m, 0.15);
}

TEST(RouteGuide, RoutesAreFoundByName) {
  const World world = open_floor();
  EXPECT_EQ(route_of(world, "bend"), world.routes.data());
  EXPECT_EQ(route_of(world, "no path"), nullptr);
}

}  // namespace
}  // namespace aisle
