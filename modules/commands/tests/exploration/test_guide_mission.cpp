#include <gmock/gmock.h>

#include <algorithm>
#include <utility>

#include "aisle/commands/set_down.hpp"
#include "aisle/evaluation/exploration/exploration_evaluation.hpp"
#include "aisle/formats/buildings/building_json.hpp"
#include "aisle/missions/exploration/guide_mission.hpp"
#include "aisle/simulation/cross_section.hpp"
#include "explorer_run.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;

/// An L of corridors 2 m wide: along x from (0, 0) to (14, 2), then up to (14, 12).
World l_building() {
  return walled_by({{0, 0}, {14, 0}, {14, 12}, {12, 12}, {12, 2}, {0, 2}}, {1.5, 1, 0});
}

bool is_floor_of_l(const Vec2& p) {
  return p.y() < 2 || p.x() > 12;
}

constexpr double kGap_m = 0.72;  // for a vehicle of 0.6 m

/// The same with a gap in a wall across its second corridor.
World narrowed_l_building() {
  World world = l_building();
  world.walls.push_back({.floor_edge = {{12, 5}, {13 - kGap_m / 2, 5}}});
  world.walls.push_back({.floor_edge = {{13 + kGap_m / 2, 5}, {14, 5}}});
  return world;
}

bool is_floor_of_narrowed_l(const Vec2& p) {
  const bool is_in_wall = std::abs(p.y() - 5) < 0.03 && std::abs(p.x() - 13) > kGap_m / 2;
  return is_floor_of_l(p) && !is_in_wall;
}

/// Corridors 2 m wide round a block, in a square of 10 m.
World ring_building() {
  World world;
  const Vec2 outer[] = {{0, 0}, {10, 0}, {10, 10}, {0, 10}}, block[] = {{2, 2}, {2, 8}, {8, 8}, {8, 2}};
  for (std::size_t i = 0; i < 4; ++i) {
    world.walls.push_back({.floor_edge = {outer[i], outer[(i + 1) % 4]}});
    world.walls.push_back({.floor_edge = {block[i], block[(i + 1) % 4]}});
  }
  world.start = Pose2{1, 1.5, kPi / 2};
  return world;
}

bool is_floor_of_ring(const Vec2& p) {
  const auto is_in_block = [](double x) { return x > 2 && x < 8; };
  return p.x() < 10 && p.y() < 10 && !(is_in_block(p.x()) && is_in_block(p.y()));
}

/// The building that a vehicle without any error would learn.
Building learned(const World& world, bool (*is_floor)(const Vec2&) = is_floor_of_l, double cell_m = 0.05) {
  Building building{.name = "corridors"};
  for (const Segment2& s : cross_section(world, 0.3))
    building.walls.walls.push_back({.segment = s, .is_orthogonal = true, .sightings = 9, .sigma_m = 0.01});
  building.corridors = true_corridors(world, cart_with_scanner().description, world.start->position());
  building.places = {{"home", *world.start}, {"lift", {13, 8, 0}, false}, {"desk", {13, 8, -kPi / 2}}};
  building.floor.emplace(cell_m);
  for (double x = cell_m / 2; x < 14; x += cell_m) {
    for (double y = cell_m / 2; y < 12; y += cell_m) {
      if (is_floor({x, y})) building.floor->set(building.floor->cell_at({x, y}), Floor::kFree);
    }
  }
  return building;
}

struct Driven {
  GuideMissionResult result;
  double shortest_m = 0;
  double coverage = 0;
  std::vector<GoalHeading> headings;
  std::size_t places_reached = 0;
};

Driven drive(const std::string& goal, const World& world = l_building(),
             const Building& building = learned(l_building()),
             const std::string& vehicle_name = "alv-scanner") {
  const SimulationSetting setting{
      .world_file = {}, .world = world, .vehicle = shipped_explorer(vehicle_name), .scenario = {}};
  auto driver =
      GuideDriver::make(GuideDriver::origin({}, building_json(building), goal), setting.vehicle.description);
  EXPECT_TRUE(driver.ok()) << to_string(driver.problems());
  std::optional<SessionRecord> no_session;
  SilentProgress progress;
  SimulatedVehicle vehicle = vehicle_in(setting, set_down_at_home(setting, *world.start, 1), 1);
  auto result = drive_guide_mission(vehicle, &vehicle, **driver, no_session, progress);
  EXPECT_TRUE(result.ok());
  const double coverage = graph_coverage((*driver)->building().corridors, result->T_map_vehicle,
                                         setting.vehicle.description.footprint);
  return {std::move(*result), (*driver)->goal().shortest_m, coverage, (*driver)->navigator().headings(),
          (*driver)->navigator().places_reached()};
}

std::string refused(const std::string& place) {
  const auto goal = goal_to(learned(l_building()), place);
  return goal.ok() ? "" : to_string(goal.problems());
}

TEST(GuideMission, GoesToAPlaceByItsNameOnAboutTheShortestPath) {
  const Driven driven = drive("go lift");
  EXPECT_TRUE(driven.result.end.arrived) << driven.result.end.why;
  EXPECT_EQ(driven.result.collisions(), 0U);
  EXPECT_LT((driven.result.T_world_vehicle.back().position() - Vec2(13, 8)).norm(), 1.5);
  EXPECT_LT(driven.result.distance_m(), driven.shortest_m + 1);
}

TEST(GuideMission, TakesANarrowGapIfThereIsNoOtherPath) {
  const World narrowed = narrowed_l_building();
  const Driven driven = drive("go lift", narrowed, learned(narrowed, is_floor_of_narrowed_l, 0.025));
  EXPECT_TRUE(driven.result.end.arrived) << driven.result.end.why;
  EXPECT_EQ(driven.result.collisions(), 0U);
}

TEST(GuideMission, PatrolsAllCorridorsAndComesHome) {
  const Driven driven = drive("patrol 1");
  EXPECT_TRUE(driven.result.end.arrived) << driven.result.end.why;
  EXPECT_EQ(driven.result.collisions(), 0U);
  EXPECT_GT(driven.coverage, 0.99);
  EXPECT_LT((driven.result.T_world_vehicle.back().position() - Vec2(1.5, 1)).norm(), 1.5);
}

TEST(GuideMission, GivesUpBeforeAPathThatIsNowClosedAndTouchesNothing) {
  World closed = l_building();
  closed.walls.push_back({.floor_edge = {{12, 5}, {14, 5}}});
  const Driven driven = drive("go lift", closed);
  EXPECT_FALSE(driven.result.end.arrived);
  EXPECT_THAT(driven.result.end.why, HasSubstr("there is no path to 13.0, 8.0"));
  EXPECT_EQ(driven.result.collisions(), 0U);
}

bool ever_met(const Barrier& barrier, const Driven& driven) {
  const Footprint footprint = cart_with_scanner().description.footprint;
  const auto& T_world_vehicle = driven.result.T_world_vehicle;
  return std::any_of(T_world_vehicle.begin(), T_world_vehicle.end(), [&](const Pose2& T) {
    return barrier_met({&barrier, 1}, footprint, T) != nullptr;
  });
}

TEST(GuideMission, GivesUpBeforeAKeepOutLineThatOnlyTheMapShows) {
  Building building = learned(l_building());
  building.barriers = {{.segment = {{12, 5}, {14, 5}}}};
  const Driven driven = drive("go lift", l_building(), building);
  EXPECT_FALSE(driven.result.end.arrived);
  EXPECT_THAT(driven.result.end.why,
              HasSubstr("no path to 13.0, 8.0 that obeys the building's keep-out lines"));
  EXPECT_FALSE(ever_met(building.barriers[0], driven));
}

TEST(GuideMission, GoesTheOtherWayRoundRatherThanThroughGlass) {
  Building building = learned(ring_building(), is_floor_of_ring);
  building.barriers = {{.kind = Barrier::Kind::kGlass, .segment = {{4, 0}, {4, 2}}}};
  const Driven driven = drive("go 6,1", ring_building(), building);
  EXPECT_TRUE(driven.result.end.arrived) << driven.result.end.why;
  EXPECT_EQ(driven.result.collisions(), 0U);
  EXPECT_GT(driven.result.distance_m(), 20) << "round the block";
  EXPECT_FALSE(ever_met(building.barriers[0], driven));
}

Zone zone_over(Zone::Kind kind, const Vec2& low, const Vec2& high) {
  return {.kind = kind, .outline = {low, {high.x(), low.y()}, high, {low.x(), high.y()}}};
}

/// In a ring, the vehicle stands at its lower left corner; its goal is along the lower corridor.
Driven drive_in_ring(const Zone& zone) {
  Building building = learned(ring_building(), is_floor_of_ring);
  building.zones = {zone};
  return drive("go 6,1", ring_building(), building);
}

constexpr double kRoundTheBlock_m = 20;

TEST(GuideMission, GoesTheOtherWayRoundRatherThanThroughAKeepOutZone) {
  const Zone zone = zone_over(Zone::Kind::kKeepOut, {3.5, -0.5}, {4, 2.5});
  const Driven driven = drive_in_ring(zone);
  EXPECT_TRUE(driven.result.end.arrived) << driven.result.end.why;
  EXPECT_GT(driven.result.distance_m(), kRoundTheBlock_m);
  for (const Barrier& edge : outlines({&zone, 1})) EXPECT_FALSE(ever_met(edge, driven));
}

TEST(GuideMission, GoesTheOtherWayRoundRatherThanAgainstAOneWayZone) {
  Zone zone = zone_over(Zone::Kind::kOneWay, {3, -0.5}, {5, 2.5});
  EXPECT_LT(drive_in_ring(zone).result.distance_m(), kRoundTheBlock_m) << "its direction is that of the path";
  zone.direction_rad = kPi;
  const Driven driven = drive_in_ring(zone);
  EXPECT_TRUE(driven.result.end.arrived) << driven.result.end.why;
  EXPECT_GT(driven.result.distance_m(), kRoundTheBlock_m);
}

TEST(GuideMission, IsSlowInASlowZoneOnly) {
  Zone zone = zone_over(Zone::Kind::kSlow, {3, -0.5}, {5, 2.5});
  zone.speed_max_mps = 0.1;
  const Driven driven = drive_in_ring(zone);
  EXPECT_TRUE(driven.result.end.arrived) << driven.result.end.why;
  const auto& T = driven.result.T_world_vehicle;
  double fastest_inside_m = 0, fastest_outside_m = 0;
  const Footprint footprint = cart_with_scanner().description.footprint;
  for (std::size_t i = 1; i < T.size(); ++i) {
    double& fastest_m = overlaps(zone, footprint, T[i - 1]) ? fastest_inside_m : fastest_outside_m;
    fastest_m = std::max(fastest_m, (T[i].position() - T[i - 1].position()).norm());
  }
  const double cycle_s = cart_with_scanner().description.cycle_s;
  EXPECT_LT(fastest_inside_m, 0.13 * cycle_s) << "for the pose is known to some centimetres only";
  EXPECT_GT(fastest_outside_m, 0.25 * cycle_s);
}

double off_deg(const Driven& driven, double heading_deg) {
  return std::abs(to_degrees(wrap_angle(driven.result.T_world_vehicle.back().theta - heading_deg * kDegree)));
}

constexpr double kFacing_deg = 11;  // 10, and what its own pose is off

void expect_arrived(const Driven& driven) {
  EXPECT_TRUE(driven.result.end.arrived) << driven.result.end.why;
  EXPECT_EQ(driven.result.end.why, "");
  EXPECT_EQ(driven.result.collisions(), 0U);
}

TEST(GuideHeading, ARobotOnTwoWheelsTurnsOnTheSpotAtItsGoal) {
  for (const double heading_deg : {-90.0, 0.0, 170.0}) {
    const Driven driven =
        drive("go 13,8," + std::to_string(heading_deg), l_building(), learned(l_building()), "turtlebot");
    expect_arrived(driven);
    EXPECT_LT((driven.result.T_world_vehicle.back().position() - Vec2(13, 8)).norm(), 0.7);
    EXPECT_LT(off_deg(driven, heading_deg), 4) << "where it can, it turns to exactly the heading";
    ASSERT_EQ(driven.headings.size(), 1U);
    EXPECT_TRUE(driven.headings[0].is_reached);
  }
}

TEST(GuideHeading, ACartTurnsWhereItHasRoomFor) {
  const Driven driven = drive("go 13,8,-90");
  expect_arrived(driven);
  EXPECT_LT(off_deg(driven, -90), kFacing_deg);
}

TEST(GuideHeading, OfANamedPlaceIsObeyed) {
  const Driven driven = drive("go desk");
  expect_arrived(driven);
  EXPECT_LT(off_deg(driven, -90), kFacing_deg);
  ASSERT_EQ(driven.headings.size(), 1U);
  EXPECT_TRUE(driven.headings[0].is_reached);
}

TEST(GuideHeading, OfHomeIsObeyedAtTheEndOfAPatrol) {
  const Driven driven = drive("patrol 1");
  expect_arrived(driven);
  EXPECT_LT(off_deg(driven, 0), kFacing_deg);
}

TEST(GuideHeading, WhereThereIsNoRoomToTurnItSaysHowFarOffItStands) {
  const World narrow = walled_by({{0, 0}, {10, 0}, {10, 1}, {0, 1}}, {1.5, 0.5, 0});
  const Building building = learned(narrow, [](const Vec2& p) { return p.x() < 10 && p.y() < 1; });
  const Driven driven = drive("go 6,0.5,90", narrow, building);
  EXPECT_TRUE(driven.result.end.arrived) << driven.result.end.why;
  EXPECT_LT((driven.result.T_world_vehicle.back().position() - Vec2(6, 0.5)).norm(), 1.5);
  EXPECT_THAT(driven.result.end.why,
              testing::MatchesRegex("at 6.0, 0.5 it stands (8[0-9]|9[0-9]) degrees off the heading 90: .*"));
  ASSERT_EQ(driven.headings.size(), 1U);
  EXPECT_FALSE(driven.headings[0].is_reached);
  EXPECT_NEAR(std::abs(driven.headings[0].off_rad), 90 * kDegree, 10 * kDegree);
}

TEST(GuideHeading, IsObeyedAtAGoalOfTheRobotsViewer) {
  const World world = l_building();
  std::optional<GoalPlace> asked = GoalPlace{{5, 1}, 180 * kDegree};
  std::string said;
  const GoalRequests requests{[&] { return std::exchange(asked, std::nullopt); },
                              [] { return std::optional<Pose2>(); },
                              [&](const std::string& words) { said += words + "\n"; }};
  SimulatedVehicle vehicle(world, shipped_explorer("turtlebot"), {}, {.T_world_start = *world.start});
  const auto follower =
      GoalFollower::make({}, building_json(learned(world)), vehicle.description(), requests);
  ASSERT_TRUE(follower.ok()) << to_string(follower.problems());
  constexpr double kTimeMax_s = 120;
  while ((*follower)->goals_reached() == 0 && vehicle.truth().stamp_s < kTimeMax_s)
    vehicle.act((*follower)->step(*vehicle.sense()).command);
  EXPECT_EQ(said, "drives to 5.00, 1.00, 180 deg\ngoal 5.00, 1.00: arrived; waits for the next one\n");
  EXPECT_NEAR(std::abs(vehicle.truth().T_world_vehicle.theta), kPi, 4 * kDegree);
}

TEST(GuideQueue, GoalsAreDrivenToInOrder) {
  const Driven driven = drive(GuideDriver::go_text({"8,1", "lift", "13,3,90"}));
  EXPECT_TRUE(driven.result.end.arrived) << driven.result.end.why;
  EXPECT_EQ(driven.places_reached, 3U);
  EXPECT_GT(driven.result.distance_m(), 18) << "to the lift, and back";
  EXPECT_LT((driven.result.T_world_vehicle.back().position() - Vec2(13, 3)).norm(), 1.5);
  EXPECT_LT(off_deg(driven, 90), kFacing_deg);
}

TEST(GuideQueue, EndsAtTheFirstGoalThatCannotBeReached) {
  World closed = l_building();
  closed.walls.push_back({.floor_edge = {{12, 5}, {14, 5}}});
  const Driven driven = drive(GuideDriver::go_text({"8,1", "lift", "3,1"}), closed);
  EXPECT_FALSE(driven.result.end.arrived);
  EXPECT_EQ(driven.places_reached, 1U);
  EXPECT_THAT(driven.result.end.why, HasSubstr("goal 2 of 3: there is no path to 13.0, 8.0"));
}

TEST(GuideQueue, GoalsAreAddedAndTakenOutOnTheWay) {
  const World world = l_building();
  SimulatedVehicle vehicle(world, shipped_explorer("turtlebot"), {}, {.T_world_start = *world.start});
  const auto made = GuideDriver::make(
      GuideDriver::origin({}, building_json(learned(world)), GuideDriver::go_text({"3,1", "lift"})),
      vehicle.description());
  ASSERT_TRUE(made.ok()) << to_string(made.problems());
  GuideDriver& driver = **made;
  constexpr double kTimeMax_s = 120;
  std::vector<GoalChange> changes = {{.added = "8,1"}, {.removed = 2}};
  const std::vector<GoalChange> ignored = {
      {.removed = 1}, {.removed = 2}, {.removed = 7}, {.added = "cellar"}};
  changes.insert(changes.end(), ignored.begin(), ignored.end());
  Decision decision;
  while (decision.status == NavigatorStatus::kGoing && vehicle.truth().stamp_s < kTimeMax_s) {
    Observation observation = *vehicle.sense();
    if (driver.navigator().places_reached() == 1)
      observation.operator_input.goal_changes = std::exchange(changes, {});
    decision = driver.step(observation);
    vehicle.act(decision.command);
  }
  EXPECT_EQ(decision.status, NavigatorStatus::kDone) << decision.why;
  EXPECT_LT((vehicle.truth().T_world_vehicle.position() - Vec2(8, 1)).norm(), 0.7);
  EXPECT_EQ(goals_json(driver.goal(), driver.navigator().places_reached()),
            R"({"goals":[{"x_m":3.0,"y_m":1.0},{"x_m":8.0,"y_m":1.0}],"reached":2})");
  EXPECT_NEAR(driver.goal().shortest_m, 6.5, 0.5);
}

TEST(GuideQueue, APatrolHasNoGoalsToChange) {
  EXPECT_EQ(goals_json(*patrol_goal(learned(l_building()), 1), 3), R"({"goals":[],"reached":3})");
}

TEST(GuideGoal, OfAQueueAllThatIsWrongIsSaid) {
  const auto goal = goal_through(learned(l_building()), {"lift", "cellar", "5,9"});
  EXPECT_THAT(to_string(goal.problems()), HasSubstr("goal 2: 'cellar' is unknown"));
  EXPECT_THAT(to_string(goal.problems()), HasSubstr("goal 3: nothing is known at 5,9"));
}

TEST(GuideGoal, APointMayHaveAHeading) {
  const Goal goal = *goal_to(learned(l_building()), "5,1.25,-270");
  EXPECT_EQ(goal.places.front().p_map, Vec2(5, 1.25));
  EXPECT_NEAR(goal.places.front().heading_rad.value(), 90 * kDegree, 1e-9);
  EXPECT_FALSE(goal_to(learned(l_building()), "5,1.25")->places.front().heading_rad);
  EXPECT_THAT(refused("5,1,400"), HasSubstr("'5,1,400' is unknown"));
}

TEST(GuideGoal, ANamedPlaceHasTheHeadingThatItsFileGives) {
  const Building building = learned(l_building());
  EXPECT_EQ(goal_to(building, "home")->places.front().heading_rad, 0.0);
  EXPECT_EQ(goal_to(building, "desk")->places.front().heading_rad, -kPi / 2);
  EXPECT_FALSE(goal_to(building, "lift")->places.front().heading_rad);
  EXPECT_FALSE(goal_to(building, "end 2")->places.front().heading_rad);
  EXPECT_EQ(patrol_goal(building, 1)->places.back().heading_rad, 0.0);
}

TEST(GuideGoal, PlacesAreNamesNodesAndPoints) {
  const Building building = learned(l_building());
  EXPECT_EQ(goal_to(building, "lift")->places.front().p_map, Vec2(13, 8));
  EXPECT_EQ(goal_to(building, "end 2")->places.front().p_map, building.corridors.nodes[1].p_map);
  EXPECT_EQ(goal_to(building, "5,1.25")->places.front().p_map, Vec2(5, 1.25));
  EXPECT_THAT(refused("cellar"), HasSubstr("'cellar' is unknown; there are home, lift, desk, end 1, end 2"));
  EXPECT_THAT(refused("5,9"), HasSubstr("nothing is known at 5,9"));
  EXPECT_THAT(refused("5,nan"), HasSubstr("'5,nan' is unknown"));
}

TEST(GuideGoal, NoPlaceLiesInAKeepOutZone) {
  Building building = learned(l_building());
  building.zones = {zone_over(Zone::Kind::kKeepOut, {12, 3}, {14, 12})};
  building.zones[0].name = "lab";
  EXPECT_THAT(to_string(goal_to(building, "lift").problems()),
              HasSubstr("'lift' lies in the keep-out zone 'lab'"));
  const Goal round = *patrol_goal(building, 1);
  for (const GoalPlace& place : round.places) EXPECT_FALSE(contains(building.zones[0], place.p_map));
}

TEST(GuideGoal, EveryRoundOfAPatrolIsAsLongAsTheFirst) {
  const Building building = learned(l_building());
  const Goal one = *patrol_goal(building, 1), three = *patrol_goal(building, 3);
  EXPECT_EQ(three.places.size() - 1, 3 * (one.places.size() - 1));
  EXPECT_FALSE(patrol_goal(building, 0).ok());
}

}  // namespace
}  // namespace aisle
