#include <gmock/gmock.h>

#include <algorithm>

#include "aisle/core/random.hpp"
#include "aisle/merging/building_merging.hpp"
#include "aisle/merging/moved_building.hpp"
#include "displacement_votes.hpp"
#include "drawn_building.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

using drawn::known;
using drawn::Plan;
using drawn::rect;

MapAlignment aligned(const Building& fixed, const Building& moved) {
  return align_maps(MapPattern(fixed), MapPattern(moved), {});
}

/// A corridor of 16 m with three rooms, from `x` on.
std::vector<drawn::Rect> wing(double x) {
  return {rect(x, 0, x + 16, 2),       rect(x + 1, 2, x + 2, 2.2),  rect(x, 2.2, x + 5, 6),
          rect(x + 8, 2, x + 9, 2.2),  rect(x + 6, 2.2, x + 12, 5), rect(x + 3, -0.2, x + 4, 0),
          rect(x + 1, -4, x + 9, -0.2)};
}

TEST(MapAlignment, FindsOverlappingPartsOfABuilding) {
  const Plan office(drawn::office());
  const Building west = known(office, rect(0, -10, 18, 10)), east = known(office, rect(9, -10, 30, 10));
  const Pose2 T_west_east{4, -2, 2.1};
  const MapAlignment found = aligned(west, moved_building(east, T_west_east.inverse()));
  ASSERT_TRUE(found.is_found()) << reason_of(found);
  EXPECT_THAT(found.best().T_fixed_moved, PoseNear(T_west_east, 0.03, 0.2 * kDegree));
  EXPECT_LT(found.best().sigma_rad(), 0.5 * kDegree);
}

TEST(MapAlignment, DoesNotDependOnTheFrames) {
  const Building east = known(Plan(drawn::office()), rect(8, -10, 30, 10));
  const MapPattern west(known(Plan(drawn::office()), rect(0, -10, 20, 10)));
  Random random(1);
  for (int i = 0; i < 8; ++i) {
    const Pose2 T_west_east{random.uniform(-40, 40), random.uniform(-40, 40), random.uniform(-kPi, kPi)};
    const MapAlignment found = align_maps(west, MapPattern(moved_building(east, T_west_east.inverse())), {});
    ASSERT_TRUE(found.is_found()) << i << ": " << reason_of(found);
    EXPECT_THAT(found.best().T_fixed_moved, PoseNear(T_west_east, 0.1, 0.3 * kDegree));
  }
}

TEST(MapAlignment, ABareCorridorIsNotBelieved) {
  const Plan corridor({rect(0, 0, 40, 2)});
  const Building west = known(corridor, rect(-1, -1, 25, 3)), east = known(corridor, rect(15, -1, 41, 3));
  EXPECT_FALSE(aligned(west, east).is_found());
}

TEST(MapAlignment, WingsThatLookAlikeAreNotTakenForEachOther) {
  std::vector<drawn::Rect> rooms = wing(0);
  rooms.push_back(rect(16, -1, 21, 3));
  for (const drawn::Rect& room : wing(21)) rooms.push_back(room);
  const Plan twins(rooms);
  const Building west = known(twins, rect(-1, -10, 20.5, 10)), east = known(twins, rect(16.5, -10, 40, 10));
  const MapAlignment found = align_maps(MapPattern(west), MapPattern(east), MergeParams{}.alignment);
  EXPECT_FALSE(found.is_found()) << reason_of(found);
}

TEST(MapAlignment, WingsThatLookAlikeCompeteWithTheHallBetweenThem) {
  std::vector<drawn::Rect> rooms = wing(0);
  for (const drawn::Rect& room : {rect(16, -5, 26, 5), rect(18, 5, 24, 9), rect(17, -8, 21, -5)})
    rooms.push_back(room);
  for (const drawn::Rect& room : wing(26)) rooms.push_back(room);
  const Plan twins(rooms);
  const Building west = known(twins, rect(-1, -10, 25.5, 10)), east = known(twins, rect(16.5, -10, 50, 10));
  EXPECT_EQ(aligned(west, east).verdict, AlignmentVerdict::kAmbiguous);
}

TEST(MapAlignment, ARowOfEqualRoomsIsAmbiguous) {
  std::vector<drawn::Rect> rooms{rect(0, 0, 40, 2)};
  for (int i = 0; i < 10; ++i) {
    rooms.push_back(rect(4 * i + 0.2, 2.2, 4 * i + 4, 6));
    rooms.push_back(rect(4 * i + 1, 2, 4 * i + 2, 2.2));
  }
  const Plan hotel(rooms);
  const Building west = known(hotel, rect(3, -1, 27, 7)), east = known(hotel, rect(13, -1, 37, 7));
  EXPECT_EQ(aligned(west, east).verdict, AlignmentVerdict::kAmbiguous);
}

TEST(MapAlignment, PartsThatDoNotOverlapAreApart) {
  const Plan office(drawn::office());
  const Building west = known(office, rect(0, -10, 12, 10)), east = known(office, rect(15, -10, 30, 10));
  EXPECT_FALSE(aligned(west, east).is_found());
}

TEST(MapAlignment, TooManyPlacementsToLookAtAreNotBelieved) {
  const Building office = known(Plan(drawn::office()));
  const MapPattern pattern(office);
  const MapAlignment found = align_maps(pattern, pattern, {.guesses_max = 0});
  EXPECT_EQ(found.verdict, AlignmentVerdict::kUnsearched);
}

TEST(DisplacementVotes, NoPlacementHasMoreInCommonThanItsSquareAllows) {
  const Building office = known(Plan(drawn::office()));
  const MapPattern pattern(office);
  const auto turns = likely_turns(pattern.samples(), pattern.samples());
  ASSERT_FALSE(turns.empty());
  EXPECT_NEAR(turns.front(), 0, 1e-9);
  const auto guesses = likely_displacements(pattern.samples(), pattern.samples(), 0, 5);
  const auto best = std::max_element(guesses.begin(), guesses.end(),
                                     [](const auto& a, const auto& b) { return a.most_m < b.most_m; });
  ASSERT_NE(best, guesses.end());
  EXPECT_NEAR(best->most_m, pattern.wall_m(), 0.01);
  EXPECT_LT(best->T_fixed_moved.position().norm(), 0.36);
}

TEST(MapOverlap, AWallOnFreeFloorIsDenied) {
  const Plan before({rect(0, 0, 10, 6)}), after({rect(0, 0, 10, 6)}, {rect(4, 2, 6, 4)});
  const Building empty = known(before), with_pillar = known(after);
  const MapOverlap overlap = overlap_of(MapPattern(empty), MapPattern(with_pillar), {});
  EXPECT_NEAR(overlap.common_m, 32, 0.5);
  EXPECT_NEAR(overlap.denied_m, 8, 0.5);
  EXPECT_NEAR(overlap.agreement(), 0.8, 0.02);
}

TEST(MapOverlap, WhatOnlyOneMapHasSeenSaysNothing) {
  const Plan office(drawn::office());
  const Building whole = known(office), part = known(office, rect(0, -10, 12, 10));
  EXPECT_NEAR(overlap_of(MapPattern(part), MapPattern(whole), {}).denied_m, 0, 0.5);
}

}  // namespace
}  // namespace aisle
