#include <gmock/gmock.h>

#include "aisle/merging/building_changes.hpp"
#include "aisle/merging/moved_building.hpp"
#include "drawn_building.hpp"

namespace aisle {
namespace {

using drawn::known;
using drawn::Plan;
using drawn::rect;

std::vector<drawn::Rect> two_rooms(bool door_is_open, double wall_at_x = 10) {
  std::vector<drawn::Rect> free{rect(0, 0, 6, 6), rect(6.2, 0, wall_at_x, 6)};
  if (door_is_open) free.push_back(rect(6, 2, 6.2, 3));
  return free;
}

TEST(BuildingChanges, NothingChangesBetweenAMapAndItself) {
  const Building office = known(Plan(drawn::office()));
  const BuildingChanges changes = changes_between(office, office, {});
  EXPECT_NEAR(changes.length_m(WallChange::kKept), office.walls.length_m(), 8);  // but for the shortest
  for (const WallChange change : {WallChange::kNew, WallChange::kGone, WallChange::kMoved})
    EXPECT_EQ(changes.length_m(change), 0);
  EXPECT_TRUE(changes.doors.empty());
  EXPECT_EQ(changes.floor.area_m2(FloorChange::kWon) + changes.floor.area_m2(FloorChange::kLost), 0);
}

TEST(BuildingChanges, TheFramesDoNotMatter) {
  const Building before = known(Plan({rect(0, 0, 10, 6)}));
  const Building after = known(Plan({rect(0, 0, 10, 6)}, {rect(4, 2, 6, 4)}));
  const Pose2 T_old_new{-3, 8, 0.7};
  const BuildingChanges changes =
      changes_between(before, moved_building(after, T_old_new.inverse()), T_old_new);
  EXPECT_NEAR(changes.length_m(WallChange::kNew), 8, 0.3);
}

TEST(BuildingChanges, APillarThatWasBuiltAndTakenAway) {
  const Building without = known(Plan({rect(0, 0, 10, 6)}));
  const Building with = known(Plan({rect(0, 0, 10, 6)}, {rect(4, 2, 6, 4)}));
  const BuildingChanges built = changes_between(without, with, {}),
                        taken = changes_between(with, without, {});
  EXPECT_NEAR(built.length_m(WallChange::kNew), 8, 0.3);
  EXPECT_EQ(built.length_m(WallChange::kGone), 0);
  EXPECT_NEAR(taken.length_m(WallChange::kGone), 8, 0.3);
  EXPECT_EQ(taken.length_m(WallChange::kNew), 0);
  EXPECT_NEAR(built.length_m(WallChange::kKept), 32, 0.5);
}

TEST(BuildingChanges, AWallThatWasMovedSaysByHowMuch) {
  const BuildingChanges changes =
      changes_between(known(Plan(two_rooms(true, 10))), known(Plan(two_rooms(true, 9.5))), {});
  EXPECT_NEAR(changes.length_m(WallChange::kMoved), 6, 0.3);
  const auto moved = std::find_if(changes.walls.begin(), changes.walls.end(), [](const ChangedWall& wall) {
    return wall.change == WallChange::kMoved && wall.is_of_new;
  });
  ASSERT_NE(moved, changes.walls.end());
  EXPECT_NEAR(moved->moved_m, 0.5, 0.01);  // towards its free side
  EXPECT_NEAR(moved->segment.midpoint().x(), 9.5, 0.01);
}

TEST(BuildingChanges, NarrowerCellsAreNoChange) {
  const Building coarse = known(Plan(drawn::office()));
  Building fine = coarse;
  fine.floor = moved_floor(*coarse.floor, {}, coarse.floor->cell_m() / 2);
  for (const auto& changes : {changes_between(coarse, fine, {}), changes_between(fine, coarse, {})}) {
    EXPECT_EQ(changes.floor.area_m2(FloorChange::kWon) + changes.floor.area_m2(FloorChange::kLost), 0);
    EXPECT_NEAR(changes.floor.area_m2(FloorChange::kSame), coarse.floor->free_m2(), 0.1);
  }
}

TEST(BuildingChanges, ADoorThatWasShutAndOpened) {
  const Building open = known(Plan(two_rooms(true))), shut = known(Plan(two_rooms(false)));
  const BuildingChanges closed = changes_between(open, shut, {}), opened = changes_between(shut, open, {});
  ASSERT_EQ(closed.doors.size(), 1u);
  EXPECT_FALSE(closed.doors[0].is_open);
  // Beside a jamb neither map can tell: an opening's ends are known to 0.3 m.
  EXPECT_NEAR(closed.doors[0].opening.length(), 1, 0.35);
  EXPECT_NEAR(closed.doors[0].opening.midpoint().y(), 2.5, 0.2);
  ASSERT_EQ(opened.doors.size(), 1u);
  EXPECT_TRUE(opened.doors[0].is_open);
}

TEST(BuildingChanges, WhatOnlyOneMapHasSeenIsNotAChange) {
  const Plan office(drawn::office());
  const Building part = known(office, rect(0, -10, 12, 10)), whole = known(office);
  for (const auto& changes : {changes_between(part, whole, {}), changes_between(whole, part, {})}) {
    EXPECT_EQ(changes.length_m(WallChange::kNew) + changes.length_m(WallChange::kGone), 0);
    EXPECT_GT(changes.length_m(WallChange::kNotCompared), 30);
    EXPECT_EQ(changes.floor.area_m2(FloorChange::kWon) + changes.floor.area_m2(FloorChange::kLost), 0);
    EXPECT_GT(changes.floor.area_m2(FloorChange::kOnlyOld) + changes.floor.area_m2(FloorChange::kOnlyNew),
              30);
  }
}

TEST(BuildingChanges, FloorIsLostWhereSomethingStandsNow) {
  Building before = known(Plan({rect(0, 0, 10, 6)})), after = before;
  for (int x = 40; x < 60; ++x) after.floor->set({x, 60}, Floor::kOccupied);
  EXPECT_NEAR(changes_between(before, after, {}).floor.area_m2(FloorChange::kLost), 20 * 0.05 * 0.05, 1e-9);
  EXPECT_NEAR(changes_between(after, before, {}).floor.area_m2(FloorChange::kWon), 20 * 0.05 * 0.05, 1e-9);
}

TEST(BuildingChanges, AMapWithoutAFloorIsRefused) {
  Building map = known(Plan({rect(0, 0, 10, 6)})), bare = map;
  bare.floor.reset();
  EXPECT_THROW(changes_between(map, bare, {}), std::invalid_argument);
}

}  // namespace
}  // namespace aisle
