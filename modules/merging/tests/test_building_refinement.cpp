#include "aisle/merging/building_refinement.hpp"

#include <gmock/gmock.h>

#include "aisle/core/random.hpp"
#include "drawn_building.hpp"

namespace aisle {
namespace {

using drawn::known;
using drawn::Plan;
using drawn::rect;

const Building& office_before() {
  static const Building office = known(Plan(drawn::office()));
  return office;
}

/// One room with a second one behind an opening of 1 m, perhaps with a pillar.
Building rooms_now(bool door_is_open, std::vector<drawn::Rect> solid = {}) {
  std::vector<drawn::Rect> free{rect(0, 0, 6, 6), rect(6.2, 0, 10, 6)};
  if (door_is_open) free.push_back(rect(6, 2, 6.2, 3));
  return known(Plan(std::move(free), std::move(solid)));
}

Building after_trips(Building building, const Building& trip, int trips) {
  for (int i = 0; i < trips; ++i) building = refined_building(building, trip, {}).building;
  return building;
}

/// Length of the walls that another map says nothing like.
double lacking_m(const Building& map, const Building& other) {
  const MapPattern own(map), pattern(other);
  double sum_m = 0;
  for (const WallSample& sample : own.samples())
    sum_m += pattern.same_wall(sample.p_map, sample.normal) == nullptr ? sample.length_m : 0;
  return sum_m;
}

int count_floor_changes(const FloorGrid& a, const FloorGrid& b) {
  int changes = 0;
  FloorBox box = a.known();
  box.include_box(b.known());
  for (int y = box.low.y; y < box.end.y; ++y) {
    for (int x = box.low.x; x < box.end.x; ++x) changes += a.at(FloorCell{x, y}) != b.at(FloorCell{x, y});
  }
  return changes;
}

TEST(BuildingRefinement, TheSameMapChangesNothing) {
  const RefinedBuilding refined = refined_building(office_before(), office_before(), {});
  EXPECT_TRUE(refined.walls.empty());
  EXPECT_NEAR(refined.moved_rms_m, 0, 1e-9);
  EXPECT_NEAR(refined.building.walls.length_m(), office_before().walls.length_m(), 1e-6);
  EXPECT_LE(refined.building.walls.walls.size(), office_before().walls.walls.size());
  EXPECT_EQ(count_floor_changes(*refined.building.floor, *office_before().floor), 0);
  for (const Wall& wall : refined.building.walls.walls) EXPECT_EQ(wall.evidence, kSureEvidence);
}

TEST(BuildingRefinement, WhatATripDidNotSeeStays) {
  const Building part = known(Plan(drawn::office()), rect(0, -10, 12, 10));
  const Building after = after_trips(office_before(), part, 5);
  EXPECT_NEAR(after.walls.length_m(), office_before().walls.length_m(), 0.5);
  EXPECT_NEAR(lacking_m(office_before(), after), lacking_m(office_before(), office_before()), 0.5);
  EXPECT_EQ(count_floor_changes(*after.floor, *office_before().floor), 0);
}

TEST(BuildingRefinement, APillarThatWasTakenAwayGoesAfterAsManyTripsAsItIsSure) {
  const Building without = rooms_now(true), with = rooms_now(true, {rect(2, 2, 3, 4)});
  Building building = with;
  for (int trip = 1; trip <= kSureEvidence; ++trip) {
    const RefinedBuilding refined = refined_building(building, without, {});
    building = refined.building;
    const bool is_last = trip == kSureEvidence;
    EXPECT_NEAR(refined.length_m(WallRefinement::kDoubted), is_last ? 0 : 6, 0.3) << trip;
    EXPECT_NEAR(refined.length_m(WallRefinement::kRemoved), is_last ? 6 : 0, 0.3) << trip;
  }
  EXPECT_NEAR(building.walls.length_m(), without.walls.length_m(), 0.3);
  EXPECT_EQ(building.floor->at(Vec2(2.5, 3)), Floor::kFree);
}

TEST(BuildingRefinement, ANewPillarIsUncertainUntilItIsSeenAgain) {
  const Building without = rooms_now(true), with = rooms_now(true, {rect(2, 2, 3, 4)});
  const RefinedBuilding once = refined_building(without, with, {});
  EXPECT_NEAR(once.length_m(WallRefinement::kAdded), 6, 0.3);
  for (const Wall& wall : once.building.walls.walls)
    EXPECT_EQ(wall.is_certain(), lacking_m(Building{.walls = {{wall}}}, without) < 0.1);
  const RefinedBuilding twice = refined_building(once.building, with, {});
  EXPECT_NEAR(twice.length_m(WallRefinement::kAssured), 6, 0.3);
  EXPECT_EQ(twice.length_m(WallRefinement::kAdded), 0);
  const RefinedBuilding gone = refined_building(once.building, without, {});
  EXPECT_NEAR(gone.building.walls.length_m(), without.walls.length_m(), 0.3);
}

TEST(BuildingRefinement, ADoorThatWasShutBecomesAWallAndOpensAgain) {
  const Building open = rooms_now(true), shut = rooms_now(false);
  const Building closed = after_trips(open, shut, kSureEvidence);
  EXPECT_NEAR(lacking_m(shut, closed), 0, 0.2);
  const Building opened = after_trips(closed, open, kSureEvidence);
  const MapPattern pattern(opened);
  EXPECT_EQ(pattern.opinion_of(Vec2(6, 2.5), Vec2(-1, 0)), MapOpinion::kDenied);
  EXPECT_LE(opened.walls.walls.size(), closed.walls.walls.size() + 2);
}

/// The office with its corridor's far end drawn off by this.
Building with_far_end_off(double off_m) {
  Building off = office_before();
  for (Wall& wall : off.walls.walls) {
    if (wall.segment.start.x() != 30 || wall.segment.end.x() != 30) continue;
    wall.segment.start.x() += off_m;
    wall.segment.end.x() += off_m;
  }
  return off;
}

double far_end_m(const Building& building) {
  return MapPattern(building).same_wall(Vec2(30, 1), Vec2(-1, 0))->segment.start.x();
}

TEST(BuildingRefinement, AWallIsMovedToWhereTripsSeeIt) {
  const Building after = after_trips(with_far_end_off(0.08), office_before(), 40);
  EXPECT_NEAR(far_end_m(after), 30, 0.01);
}

TEST(BuildingRefinement, ATripThatIsOffAsAWholeDoesNotMoveTheFrame) {
  Building off = office_before();
  for (Wall& wall : off.walls.walls) wall.segment = Pose2{0.03, -0.03, 0} * wall.segment;
  const RefinedBuilding refined = refined_building(office_before(), off, {});
  EXPECT_LT(refined.moved_rms_m, 1e-3);
  EXPECT_NEAR(far_end_m(refined.building), 30, 1e-3);
}

TEST(BuildingRefinement, AWallNeverWeighsMoreThanTheTripsThatAreRemembered) {
  const RefinementParams params{.trip_sigma_m = 0.01, .trips_remembered = 4};
  Building building = office_before();
  for (int i = 0; i < 20; ++i) building = refined_building(building, office_before(), params).building;
  for (const Wall& wall : building.walls.walls) EXPECT_GE(wall.sigma_m, 0.01 / 2 - 1e-9);
}

TEST(BuildingRefinement, FiftyTripsWithFurnitureElsewhereDoNotGrowIt) {
  Random random(1);
  const Building empty = rooms_now(true);
  const auto furnished = [&] {
    std::vector<drawn::Rect> pieces;
    for (int i = 0; i < 4; ++i) {
      const double x = 0.2 + 0.05 * static_cast<double>(random.index(90)),
                   y = 0.2 + 0.05 * static_cast<double>(random.index(90));
      pieces.push_back(rect(x, y, x + 0.8, y + 0.5));
    }
    return rooms_now(true, pieces);
  };
  Building building = furnished();
  for (int trip = 0; trip < 50; ++trip) {
    building = refined_building(building, furnished(), {}).building;
    EXPECT_LT(building.walls.length_m(), empty.walls.length_m() + 40) << trip;
  }
  EXPECT_NEAR(lacking_m(empty, building), 0, 4);
}

TEST(BuildingRefinement, WhatAPersonDrewStays) {
  Building building = office_before();
  building.places = {{kHomePlace, {1, 1, 0}}, {"lift", {20, 1, 0}}};
  building.zones = {{.kind = Zone::Kind::kKeepOut, .name = "x", .outline = {{3, 0}, {4, 0}, {4, 1}}}};
  building.barriers = {{}};
  building.corridors.nodes.push_back({});
  const Building after = refined_building(building, office_before(), {}).building;
  EXPECT_EQ(after.places.size(), 2u);
  EXPECT_EQ(after.zones.size(), 1u);
  EXPECT_EQ(after.barriers.size(), 1u);
  EXPECT_EQ(after.corridors.nodes.size(), 1u);
}

TEST(BuildingRefinement, ATripThroughAnotherBuildingDoesNotFit) {
  const MapPattern office(office_before()), rooms(rooms_now(true));
  EXPECT_TRUE(is_of_building(overlap_of(office, office, {}), {}));
  EXPECT_FALSE(is_of_building(overlap_of(office, rooms, {12, -3, 0}), {}));
}

TEST(BuildingRefinement, AMapWithoutAFloorIsRefused) {
  Building bare = office_before();
  bare.floor.reset();
  EXPECT_THROW(refined_building(office_before(), bare, {}), std::invalid_argument);
}

}  // namespace
}  // namespace aisle
