#include <gtest/gtest.h>

#include "aisle/guidance/paths/car_search.hpp"
#include "free_floor.hpp"

namespace aisle {
namespace {

/// Every pose of the path lies on known free floor, and the wheels can drive it.
void expect_drivable(const Path& path, const KnownFloor& known, const VehicleDescription& vehicle) {
  const FootprintClearance footprint_clearance(vehicle.footprint, 0);
  for (double along_m = 0; along_m <= path.length_m(); along_m += 0.02) {
    const PathPoint point = path.at(along_m);
    EXPECT_TRUE(footprint_clearance.fits_barely(known, point.T_map_path, {-1, -1})) << along_m;
    if (vehicle.is_differential) continue;
    EXPECT_LE(std::abs(point.curvature_per_m) * vehicle.front_steered.wheelbase_m,
              std::tan(vehicle.limits.steering_max_rad));
  }
}

CarSearch::State run(const KnownFloor& known, CarSearch& search) {
  while (search.advance(known, 100000) == CarSearch::State::kSearching) continue;
  return search.state();
}

class CarSearchOfEitherDrive : public testing::TestWithParam<bool> {
 protected:
  const VehicleDescription vehicle_ = cart_of(GetParam());
};

INSTANTIATE_TEST_SUITE_P(, CarSearchOfEitherDrive, testing::Bool(), name_of_drive);

double no_guide(const Vec2&) {
  return 0;
}

TEST_P(CarSearchOfEitherDrive, TurnsRoundInACorridorWhereItCan) {
  const KnownFloor known = free_floor({{Vec2(0, 0), Vec2(12, 2.2)}});
  CarSearch search({}, vehicle_);
  search.look_for(
      {3, 1.1, 0}, [](const Pose2& T) { return std::abs(wrap_angle(T.theta - kPi)) < 0.1; }, no_guide);
  ASSERT_EQ(run(known, search), CarSearch::State::kFound);
  expect_drivable(search.path(), known, vehicle_);
}

TEST_P(CarSearchOfEitherDrive, ReversesOutOfWhereItCannotTurn) {
  const KnownFloor known = free_floor({{Vec2(0, 0), Vec2(8, 0.95)}, {Vec2(0, 0), Vec2(2.2, 4)}});
  CarSearch search({}, vehicle_);
  search.look_for(
      {6, 0.475, 0}, [](const Pose2& T) { return T.y > 2; },
      [](const Vec2& p) { return std::max(0.0, 2 - p.y()); });
  ASSERT_EQ(run(known, search), CarSearch::State::kFound);
  EXPECT_LT(search.path().pieces().front().arc.length_m, 0);
  expect_drivable(search.path(), known, vehicle_);
}

TEST_P(CarSearchOfEitherDrive, LeavesADoorwayThatIsTooNarrowToEnter) {
  KnownFloor known =
      free_floor({{Vec2(0, 0), Vec2(3, 3)}, {Vec2(3, 1.15), Vec2(3.2, 1.85)}, {Vec2(3.2, 0), Vec2(6, 3)}});
  for (int y = 0; y < 60; ++y) {
    if (y < 23 || y >= 37) occupy(known, {62, y});
  }
  CarSearch search({}, vehicle_);
  const auto beyond = [](const Pose2& T) { return T.x > 4; };
  search.look_for({1, 1.5, 0}, beyond, no_guide);
  EXPECT_EQ(run(known, search), CarSearch::State::kNone);
  search.look_for({2.9, 1.5, 1 * kDegree}, beyond, no_guide);
  EXPECT_EQ(run(known, search), CarSearch::State::kFound);
  EXPECT_GT(search.reached_m(), 1);
}

TEST_P(CarSearchOfEitherDrive, BeginsInTheOtherDirectionIfOneIsForbidden) {
  const KnownFloor known = free_floor({{Vec2(0, 0), Vec2(10, 5)}});
  CarSearch search({}, vehicle_);
  search.look_for(
      {4, 2.5, 0}, [](const Pose2& T) { return T.x > 7; }, no_guide);
  search.forbid_first(LegDirection::kForward);
  ASSERT_EQ(run(known, search), CarSearch::State::kFound);
  EXPECT_NE(direction_of(search.path().pieces().front().arc), LegDirection::kForward);
}

TEST_P(CarSearchOfEitherDrive, AvoidsForbiddenPosesThatTheFloorShowsAsFree) {
  const KnownFloor known = free_floor({{Vec2(0, 0), Vec2(12, 5)}});
  CarSearch search({}, vehicle_);
  const auto is_free = [](const Pose2& T) { return (T.position() - Vec2(6, 2.5)).norm() > 1; };
  search.look_for(
      {2, 2.5, 0}, [](const Pose2& T) { return T.x > 9; }, no_guide);
  search.keep_to(is_free);
  ASSERT_EQ(run(known, search), CarSearch::State::kFound);
  const Path path = search.path();
  for (double along_m = 0; along_m <= path.length_m(); along_m += 0.05)
    EXPECT_GT((path.at(along_m).T_map_path.position() - Vec2(6, 2.5)).norm(), 0.98);
}

TEST_P(CarSearchOfEitherDrive, EndsExactlyAtAPose) {
  const KnownFloor known = free_floor({{Vec2(0, 0), Vec2(10, 5)}});
  CarSearch search({}, vehicle_);
  const Pose2 T_map_goal{2, 2, 0.3}, T_map_vehicle{8, 3, 1};
  search.look_for_path_to(T_map_goal, T_map_vehicle,
                          [&](const Vec2& p) { return (p - T_map_vehicle.position()).norm(); });
  ASSERT_EQ(run(known, search), CarSearch::State::kFound);
  const Path path = search.path();
  const Pose2 missed = between(T_map_goal, path.end());
  EXPECT_LT(missed.position().norm(), 1e-6);
  EXPECT_LT(std::abs(missed.theta), 1e-6);
  EXPECT_LT((path.at(0).T_map_path.position() - T_map_vehicle.position()).norm(), 0.13);
  expect_drivable(path, known, vehicle_);
}

TEST_P(CarSearchOfEitherDrive, EndsAtAnyGoodPose) {
  const KnownFloor known = free_floor({{Vec2(0, 0), Vec2(10, 5)}});
  CarSearch search({}, vehicle_);
  const auto is_good = [](const Pose2& T) { return T.x < 3 && std::abs(wrap_angle(T.theta - kPi)) < 0.2; };
  const Pose2 T_map_vehicle{8, 3, 1};
  const FloorBox places{known.grid().cell_at({1, 1}), known.grid().cell_at({5, 4})};
  search.look_for_path_to_any(is_good, places, T_map_vehicle,
                              [&](const Vec2& p) { return (p - T_map_vehicle.position()).norm(); });
  ASSERT_EQ(run(known, search), CarSearch::State::kFound);
  const Path path = search.path();
  EXPECT_TRUE(is_good(path.end()));
  EXPECT_LT((path.at(0).T_map_path.position() - T_map_vehicle.position()).norm(), 0.13);
  expect_drivable(path, known, vehicle_);
}

TEST(CarSearch, TriesFewPosesWhereAllGoodOnesAreShutOff) {
  const KnownFloor hall_and_closet = free_floor({{Vec2(0, 0), Vec2(20, 20)}, {Vec2(22, 0), Vec2(24, 2)}});
  CarSearch search({}, cart());
  const auto in_the_closet = [](const Pose2& T) { return T.x > 22; };
  search.look_for_path_to_any(in_the_closet, hall_and_closet.grid().known(), {5, 5, 0}, no_guide);
  EXPECT_EQ(run(hall_and_closet, search), CarSearch::State::kNone);
  EXPECT_TRUE(search.has_tried_all());
  EXPECT_LT(search.expansions(), 5000);
}

TEST_P(CarSearchOfEitherDrive, TriesNoMoreEndsThanAPortionAllows) {
  const KnownFloor hall = free_floor({{Vec2(0, 0), Vec2(20, 20)}});
  CarSearch search({}, vehicle_);
  int tried = 0;
  const auto never = [&](const Pose2&) {
    ++tried;
    return false;
  };
  search.look_for_path_to_any(never, hall.grid().known(), {5, 5, 0}, no_guide);
  while (search.advance(hall, 500) == CarSearch::State::kSearching) {
    EXPECT_LT(tried, 2000);
    tried = 0;
  }
  EXPECT_TRUE(search.has_tried_all());
}

/// One leg for the whole turn: at each stop the vehicle would slow down.
TEST(CarSearch, TurnsOnTheSpotInOneGo) {
  const KnownFloor known = free_floor({{Vec2(0, 0), Vec2(12, 3)}});
  CarSearch search({}, differential_cart());
  search.look_for(
      {3, 1.5, 0}, [](const Pose2& T) { return std::abs(wrap_angle(T.theta - kPi)) < 0.1; }, no_guide);
  ASSERT_EQ(run(known, search), CarSearch::State::kFound);
  const Path path = search.path();
  ASSERT_EQ(path.pieces().size(), 1U);
  EXPECT_TRUE(path.pieces().front().is_on_the_spot());
  search.look_for(
      {3, 1.5, 0}, [](const Pose2& T) { return std::abs(wrap_angle(T.theta - kPi / 2)) < 0.1; }, no_guide);
  search.forbid_first(LegDirection::kLeft);
  ASSERT_EQ(run(known, search), CarSearch::State::kFound);
  EXPECT_NE(direction_of(search.path().pieces().front().arc), LegDirection::kLeft);
}

TEST(CarSearch, PassesANarrowGapWithRelaxedClearance) {
  const KnownFloor room_off_corridor = free_floor(
      {{Vec2(0, 0), Vec2(8, 1.25)}, {Vec2(4, 1.25), Vec2(4.85, 1.45)}, {Vec2(2.5, 1.45), Vec2(6.5, 4.5)}});
  CarSearch search({}, cart());
  const Pose2 T_map_vehicle{1, 0.625, 0};
  const auto in_the_room = [](const Pose2& T) { return T.y > 2; };
  search.look_for(T_map_vehicle, in_the_room, no_guide);
  EXPECT_EQ(run(room_off_corridor, search), CarSearch::State::kNone);
  search.look_for(T_map_vehicle, in_the_room, no_guide);
  search.relax_clearance();
  ASSERT_EQ(run(room_off_corridor, search), CarSearch::State::kFound);
  expect_drivable(search.path(), room_off_corridor, cart());
}

TEST_P(CarSearchOfEitherDrive, FindsNoPathBeyondKnownFloor) {
  const KnownFloor known = free_floor({{Vec2(0, 0), Vec2(4, 2)}});
  CarSearch search({}, vehicle_);
  search.look_for(
      {2, 1, 0}, [](const Pose2& T) { return T.x > 6; }, no_guide);
  EXPECT_EQ(run(known, search), CarSearch::State::kNone);
}

TEST(CarSearch, CrossesUnknownFloorWhereItBeginsOnlyIfAsked) {
  KnownFloor across_a_corridor = free_floor({{Vec2(2.65, 1.2), Vec2(3.35, 2.5)}, {Vec2(0, 2), Vec2(8, 3)}});
  for (int x = 0; x < 160; ++x) occupy(across_a_corridor, {x, 60});
  CarSearch search({}, cart());
  const Pose2 T_map_vehicle{3, 1.5, kPi / 2};
  const auto along_it = [](const Pose2& T) { return T.x > 6; };
  search.look_for(T_map_vehicle, along_it, no_guide);
  search.relax_clearance();
  EXPECT_EQ(run(across_a_corridor, search), CarSearch::State::kNone);
  search.look_for(T_map_vehicle, along_it, no_guide);
  search.relax_clearance();
  search.cross_unknown();
  ASSERT_EQ(run(across_a_corridor, search), CarSearch::State::kFound);
  const FootprintClearance footprint_clearance(cart().footprint, 0);
  const Path path = search.path();
  for (double along_m = 0; along_m <= path.length_m(); along_m += 0.02) {
    const Pose2 T_map = path.at(along_m).T_map_path;
    EXPECT_TRUE(footprint_clearance.lies_off_occupied(across_a_corridor, T_map)) << along_m;
    if ((T_map.position() - T_map_vehicle.position()).norm() > 2.3)
      EXPECT_TRUE(footprint_clearance.lies_on_free(across_a_corridor, T_map)) << along_m;
  }
}

TEST_P(CarSearchOfEitherDrive, KnowsWhereItCameIfItFoundNoPath) {
  const KnownFloor two_rooms = free_floor({{Vec2(0, 0), Vec2(4, 4)}, {Vec2(6, 0), Vec2(10, 4)}});
  CarSearch search({}, vehicle_);
  search.look_for(
      {2, 2, 0}, [](const Pose2&) { return false; }, no_guide);
  EXPECT_EQ(run(two_rooms, search), CarSearch::State::kNone);
  EXPECT_TRUE(search.has_tried_all());
  EXPECT_TRUE(search.has_come_to({1, 3}, 0.3));
  EXPECT_FALSE(search.has_come_to({8, 2}, 1.5));
}

TEST_P(CarSearchOfEitherDrive, FindsTheSamePathInPortions) {
  const KnownFloor known = free_floor({{Vec2(0, 0), Vec2(12, 2.2)}});
  const auto is_turned = [](const Pose2& T) { return std::abs(wrap_angle(T.theta - kPi)) < 0.1; };
  CarSearch whole({}, vehicle_), portions({}, vehicle_);
  whole.look_for({3, 1.1, 0}, is_turned, no_guide);
  portions.look_for({3, 1.1, 0}, is_turned, no_guide);
  run(known, whole);
  while (portions.advance(known, 17) == CarSearch::State::kSearching) continue;
  EXPECT_EQ(portions.expansions(), whole.expansions());
  EXPECT_EQ(portions.path().length_m(), whole.path().length_m());
}

}  // namespace
}  // namespace aisle
