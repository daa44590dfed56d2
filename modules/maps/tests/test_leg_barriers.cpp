#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "aisle/core/random.hpp"
#include "aisle/maps/floor_clearance.hpp"
#include "aisle/maps/leg_barriers.hpp"

namespace aisle {
namespace {

/// A free floor of 8 m x 6 m with obstacles on it.
class LegBarriersOnAFloor : public testing::Test {
 protected:
  LegBarriersOnAFloor() {
    for (int y = 0; y < 120; ++y) {
      for (int x = 0; x < 160; ++x) floor_.set({x, y}, Floor::kFree);
    }
  }
  void stand(double x_m, double y_m) { floor_.set(floor_.cell_at({x_m, y_m}), Floor::kOccupied); }
  void wall(double x_m, double from_y_m, double to_y_m) {
    for (double y_m = from_y_m; y_m < to_y_m; y_m += 0.05) stand(x_m, y_m);
  }
  void wall_across(double y_m, double from_x_m, double to_x_m) {
    for (double x_m = from_x_m; x_m < to_x_m; x_m += 0.05) stand(x_m, y_m);
  }
  void hide(const Vec2& low, const Vec2& high) {
    for (double x_m = low.x(); x_m < high.x(); x_m += 0.05) {
      for (double y_m = low.y(); y_m < high.y(); y_m += 0.05)
        floor_.set(floor_.cell_at({x_m, y_m}), Floor::kUnknown);
    }
  }
  /// At (5.02, 1.02), nothing seen behind its walls.
  void corner_at_the_right() {
    wall(5.02, 1, 6);
    wall_across(1.02, 0, 5);
    hide({5.07, 0}, {8, 6});
    hide({0, 0}, {8, 1});
  }
  /// A small obstacle before each of two walls that are 2 m apart.
  void obstacles_before_opposite_walls(double y_m, double walls_to_y_m) {
    wall(2.02, 1, walls_to_y_m);
    wall(4.02, 1, walls_to_y_m);
    stand(2.22, y_m);
    stand(3.82, y_m);
  }
  /// Whether a straight path crosses a closed cell.
  bool is_closed(const Vec2& from, const Vec2& to) {
    LegBarriers barriers;
    barriers.update(floor_, floor_.known());
    for (double share = 0; share <= 1; share += 0.005) {
      if (barriers.is_closed(floor_.cell_at(Vec2(from + share * (to - from))))) return true;
    }
    return false;
  }
  FloorGrid floor_;
};

TEST_F(LegBarriersOnAFloor, CloseTheFloorUnderATable) {
  for (const double x_m : {3.02, 4.62}) {
    for (const double y_m : {2.02, 2.92}) stand(x_m, y_m);
  }
  EXPECT_TRUE(is_closed({3.8, 1}, {3.8, 4}));
  EXPECT_TRUE(is_closed({2, 2.5}, {6, 2.5}));
  EXPECT_FALSE(is_closed({2, 1.6}, {6, 1.6}));
}

TEST_F(LegBarriersOnAFloor, LeaveObstaclesAloneThatStandFarApart) {
  stand(2.02, 3.02);
  stand(4.22, 3.02);
  EXPECT_FALSE(is_closed({3, 1}, {3, 5}));
}

TEST_F(LegBarriersOnAFloor, DoNotTakeTheEndsOfWallsForLegs) {
  wall(3, 0, 2);
  wall(3, 3.2, 5);
  stand(4.02, 2.62);
  EXPECT_FALSE(is_closed({2, 2.6}, {6, 2.6}));
}

TEST_F(LegBarriersOnAFloor, DoNotTakeSpecksOfAWallsOtherFaceForLegs) {
  wall(3, 0, 2);
  wall(3, 3, 6);
  for (const double y_m : {1.82, 3.12}) stand(3.12, y_m);
  EXPECT_FALSE(is_closed({2, 2.5}, {6, 2.5}));
}

TEST_F(LegBarriersOnAFloor, DoNotTakeAWallSeenFromFarForLegs) {
  for (int y = 0; y < 120; ++y) {
    for (int x = 80; x < 160; ++x) floor_.set({x, y}, Floor::kUnknown);
  }
  for (double y_m = 1; y_m < 5; y_m += 0.3) stand(4, y_m);
  EXPECT_FALSE(is_closed({2, 3}, {6, 3}));
  EXPECT_FALSE(is_closed({4, 0}, {4, 6}));
}

/// At a grazing angle a wall is hit here and there, and a view passes it on either side.
TEST_F(LegBarriersOnAFloor, LeaveACorridorOpenOfWhoseWallsOnlyPiecesWereSeen) {
  wall_across(2.02, 1, 2.5);
  wall_across(3.42, 1, 2.5);
  for (int i = 0; i < 8; ++i) {
    stand(3.02 + 0.25 * i, 2.02 + 0.05 * (i % 2));
    stand(3.12 + 0.25 * i, 3.42 - 0.05 * (i % 2));
  }
  EXPECT_FALSE(is_closed({2, 2.7}, {6, 2.7}));
}

TEST_F(LegBarriersOnAFloor, CloseTheFloorUnderARowOfTables) {
  for (int i = 0; i < 8; ++i) {
    stand(3.02 + 0.25 * i, 2.02);
    stand(3.12 + 0.25 * i, 3.02);
  }
  EXPECT_TRUE(is_closed({2, 2.5}, {6, 2.5}));
}

TEST_F(LegBarriersOnAFloor, CloseTheFloorUnderATableWithChairs) {
  for (const double x_m : {3.02, 4.42}) {
    for (const double y_m : {2.02, 2.82}) stand(x_m, y_m);
  }
  for (const double x_m : {3.27, 3.62, 3.87, 4.22}) stand(x_m, 2.02);
  EXPECT_TRUE(is_closed({3.05, 2.4}, {6, 2.4}));
  EXPECT_TRUE(is_closed({4.32, 3.5}, {4.32, 2.2}));
}

TEST_F(LegBarriersOnAFloor, CloseTheFloorBetweenAWallAndATableAtIt) {
  wall(2, 0, 6);
  stand(2.87, 2.02);
  stand(2.87, 3.62);
  EXPECT_TRUE(is_closed({2.4, 1}, {2.4, 5}));
}

/// A corner of a room: the front legs of a table, one of them beside a cupboard.
TEST_F(LegBarriersOnAFloor, CloseThePathUnderATableAtAWallThatAChairStandsBefore) {
  wall(3.9, 0, 6);
  for (const double y_m : {2.02, 2.57, 3.02, 3.57}) stand(3.02, y_m);
  for (const double y_m : {2.57, 3.02}) stand(2.57, y_m);
  EXPECT_TRUE(is_closed({3.5, 1}, {3.5, 5}));
}

TEST_F(LegBarriersOnAFloor, CloseThePathUnderATableThatStandsBesideACupboard) {
  wall(2, 0, 6);
  for (double x_m = 2; x_m < 3.5; x_m += 0.05) {
    for (double y_m = 3.8; y_m < 4.2; y_m += 0.05) stand(x_m, y_m);
  }
  stand(2.87, 2.02);
  stand(2.87, 3.62);
  EXPECT_TRUE(is_closed({4, 2.8}, {2.2, 2.8}));
}

/// Nearest to the other leg is an obstacle at the wall, diagonally behind it.
TEST_F(LegBarriersOnAFloor, CloseThePathUnderATableWithALegAtACupboardsCorner) {
  wall(2, 0, 6);
  stand(2.17, 1.77);
  for (double x_m = 3.02; x_m < 3.6; x_m += 0.05) {
    for (const double y_m : {3.67, 3.72}) stand(x_m, y_m);
  }
  hide({3.02, 3.77}, {3.6, 6});
  stand(2.87, 2.02);
  for (const double y_m : {3.52, 3.57, 3.62}) stand(2.87, y_m);
  EXPECT_TRUE(is_closed({4, 2.8}, {2.2, 2.8}));
}

TEST_F(LegBarriersOnAFloor, LeaveFloorOpenOnWhichTheVehicleStood) {
  stand(3.02, 2.02);
  stand(4.62, 2.02);
  EXPECT_TRUE(is_closed({3.8, 1}, {3.8, 4}));
  floor_.stand_on(floor_.cell_at({4.2, 2.02}));
  EXPECT_FALSE(is_closed({3.8, 1}, {3.8, 4}));
}

/// Seen from a door that opens beside it: half of its legs' surroundings is unseen.
TEST_F(LegBarriersOnAFloor, CloseThePathUnderATableThatHidesItsSurroundings) {
  stand(2.87, 2.02);
  stand(2.87, 3.62);
  hide({2.02, 3.52}, {2.8, 3.7});
  hide({2.02, 3.77}, {2.95, 5});
  EXPECT_TRUE(is_closed({4, 2.8}, {2.2, 2.8}));
}

TEST_F(LegBarriersOnAFloor, CloseThePathToWhereATablesOtherLegMayBeHidden) {
  wall(2, 0, 6);
  stand(2.87, 2.02);
  EXPECT_FALSE(is_closed({4, 2.8}, {2.2, 2.8}));
  hide({2.02, 3.52}, {5, 6});
  EXPECT_TRUE(is_closed({4, 2.8}, {2.2, 2.8}));
  EXPECT_FALSE(is_closed({4, 1.5}, {2.2, 1.5}));
  stand(2.87, 3.02);
  hide({2.02, 0}, {5, 1});
  EXPECT_FALSE(is_closed({4, 1.5}, {2.2, 1.5}));
}

/// The back leg is connected to the wall, which is as far from the front legs as it may be.
TEST_F(LegBarriersOnAFloor, CloseThePathToAHiddenLegThoughTheBackLegHidesTheWallBehind) {
  wall(2, 0, 6);
  for (const double x_m : {2.07, 2.12}) stand(x_m, 2.02);
  stand(2.92, 2.02);
  for (const double y_m : {2.02, 2.07}) stand(2.97, y_m);
  EXPECT_FALSE(is_closed({4, 2.8}, {2.2, 2.8}));
  hide({2.4, 3.52}, {5, 6});
  EXPECT_TRUE(is_closed({4, 2.8}, {2.2, 2.8}));
}

/// The other leg is a speck like those of the wall beside it, of which little was seen.
TEST_F(LegBarriersOnAFloor, CloseThePathToATablesOtherLegAtAnotherWall) {
  wall(2, 0, 4);
  for (const double x_m : {2.12, 2.27, 2.52, 2.87, 3.07}) stand(x_m, 3.82);
  hide({2.02, 3.87}, {5, 6});
  stand(2.87, 2.02);
  EXPECT_FALSE(is_closed({4, 1.5}, {2.2, 1.5}));
  stand(2.87, 3.67);
  EXPECT_TRUE(is_closed({4, 2.8}, {2.2, 2.8}));
}

TEST_F(LegBarriersOnAFloor, CloseThePathToAHiddenLegOfATableInACorner) {
  wall(2, 1, 6);
  wall_across(1, 2, 6);
  stand(2.87, 1.22);
  EXPECT_FALSE(is_closed({4, 1.8}, {2.3, 1.8}));
  hide({2.02, 2.52}, {5, 6});
  EXPECT_TRUE(is_closed({4, 1.8}, {2.3, 1.8}));
  EXPECT_FALSE(is_closed({2.5, 1.3}, {2.5, 2.4}));
}

TEST_F(LegBarriersOnAFloor, CloseThePathUnderATableInACornerWhoseOtherLegIsConnectedToTheWall) {
  corner_at_the_right();
  stand(4.17, 2.82);
  EXPECT_FALSE(is_closed({3.8, 2}, {4.6, 2}));
  for (const double y_m : {1.07, 1.12}) stand(4.17, y_m);
  EXPECT_TRUE(is_closed({3.8, 2}, {4.6, 2}));
  stand(4.22, 1.07);  // blurred
  EXPECT_TRUE(is_closed({3.8, 2}, {4.6, 2}));
  EXPECT_FALSE(is_closed({3.8, 1.3}, {3.8, 5}));
}

/// The table's leg at the far end is hidden, too.
TEST_F(LegBarriersOnAFloor, CloseThePathFromALegConnectedToTheWallToAHiddenOne) {
  corner_at_the_right();
  hide({4, 2.5}, {5, 3.5});
  EXPECT_FALSE(is_closed({3.8, 2}, {4.6, 2}));
  stand(4.17, 1.07);  // may be a blurred piece of the wall
  EXPECT_FALSE(is_closed({3.8, 2}, {4.6, 2}));
  stand(4.17, 1.12);
  EXPECT_TRUE(is_closed({3.8, 2}, {4.6, 2}));
}

/// The speck at the wall behind is not another front leg.
TEST_F(LegBarriersOnAFloor, CloseThePathToAHiddenLegThoughASpeckStandsAtTheWallBehind) {
  wall(2, 0, 6);
  stand(2.87, 2.02);
  stand(2.12, 3.22);
  hide({2.8, 3.52}, {5, 6});
  EXPECT_TRUE(is_closed({4, 3.4}, {2.5, 3.4}));
}

/// Two tables are side by side, one of them farther out.
TEST_F(LegBarriersOnAFloor, CloseThePathToAHiddenLegThoughTheNextTablesLegStandsBeside) {
  wall(2, 0, 6);
  stand(2.87, 3.02);
  hide({2.02, 0}, {5, 1.6});
  EXPECT_TRUE(is_closed({4, 2.2}, {2.2, 2.2}));
  stand(2.72, 3.22);
  EXPECT_TRUE(is_closed({4, 2.2}, {2.2, 2.2}));
}

/// The speck stands out of the wall nearest to the leg and so is its nearest point.
TEST_F(LegBarriersOnAFloor, CloseThePathToAHiddenLegThoughASpeckOfTheNearestWallLiesToTheSide) {
  wall(4, 2, 6);
  wall_across(2, 0, 4.05);
  stand(3.12, 2.37);
  hide({2.9, 3.52}, {3.4, 6});
  EXPECT_TRUE(is_closed({2.5, 3}, {3.5, 3}));
  for (const double x_m : {2.77, 2.97}) stand(x_m, 2.07);
  EXPECT_TRUE(is_closed({2.5, 3}, {3.5, 3}));
}

TEST_F(LegBarriersOnAFloor, CloseThePathUnderATableWhoseSideIsNearAWall) {
  wall_across(3.87, 1, 5);
  stand(2.87, 2.02);
  stand(2.87, 3.62);
  stand(2.92, 3.62);
  EXPECT_TRUE(is_closed({4, 2.8}, {2.2, 2.8}));
}

TEST_F(LegBarriersOnAFloor, CloseThePathUnderATableThatFillsARecess) {
  wall_across(1.02, 2, 4);
  obstacles_before_opposite_walls(1.72, 3);
  EXPECT_TRUE(is_closed({3, 2.5}, {3, 1.3}));
}

TEST_F(LegBarriersOnAFloor, LeaveACorridorOpenBetweenSpecksBeforeItsWalls) {
  obstacles_before_opposite_walls(3.02, 6);
  EXPECT_FALSE(is_closed({3, 5}, {3, 1.3}));
}

/// The leaf ends beside the leg and hides part of its surroundings.
TEST_F(LegBarriersOnAFloor, CloseThePathToATablesOtherLegBesideAnOpenDoorsLeaf) {
  wall(2, 0, 6);
  wall_across(3.87, 2, 2.8);
  stand(2.87, 2.02);
  EXPECT_FALSE(is_closed({4, 2.8}, {2.2, 2.8}));
  stand(2.87, 3.62);
  hide({2.02, 3.3}, {2.85, 3.85});
  EXPECT_TRUE(is_closed({4, 2.8}, {2.2, 2.8}));
}

TEST_F(LegBarriersOnAFloor, CloseThePathToAHiddenLegThoughACupboardsCornerIsNearerThanTheWall) {
  wall(2, 0, 6);
  wall(3.2, 3.5, 4.2);
  wall_across(3.5, 3.2, 4);
  hide({3.25, 3.55}, {4, 4.2});
  stand(2.87, 3.02);
  hide({2.02, 0}, {3.5, 1.4});
  EXPECT_TRUE(is_closed({4, 2.2}, {2.2, 2.2}));
}

/// Of the wall with the door, only the frame was seen from inside: it does not say how a table stands.
TEST_F(LegBarriersOnAFloor, LeaveADoorOpenBesideWhichALegStands) {
  wall(1.85, 0, 2);
  wall_across(1.97, 1.85, 2.05);
  wall(2, 3, 6);
  wall_across(3.07, 2, 2.85);
  stand(2.62, 1.77);
  hide({2, 0}, {2.4, 1.85});
  hide({2.05, 3.1}, {3.2, 6});
  EXPECT_FALSE(is_closed({1, 2.5}, {6, 2.5}));
}

TEST_F(LegBarriersOnAFloor, DoNotTakeASpeckBehindAWallForALegOfATableBeforeIt) {
  wall(3, 0, 6);
  stand(3.12, 3.02);
  stand(2.47, 2.02);
  EXPECT_FALSE(is_closed({1, 2.6}, {2.95, 2.6}));
}

TEST_F(LegBarriersOnAFloor, DoNotTakeAWallsLastSpeckForALegOfATableBeyondItsEnd) {
  wall(2, 0, 2);
  stand(2, 2.17);
  stand(3.02, 3.62);
  EXPECT_FALSE(is_closed({2.6, 1}, {2.6, 5}));
}

TEST_F(LegBarriersOnAFloor, LeaveAPassageBetweenAWallAndAChair) {
  wall(2, 0, 6);
  for (const double x_m : {2.87, 3.27}) {
    for (const double y_m : {2.02, 2.42}) stand(x_m, y_m);
  }
  EXPECT_FALSE(is_closed({2.4, 1}, {2.4, 5}));
}

TEST_F(LegBarriersOnAFloor, DoNotReachThroughWalls) {
  wall(3, 0, 6);
  stand(2.27, 3.02);
  stand(3.72, 3.02);
  EXPECT_FALSE(is_closed({2.6, 1}, {2.6, 5}));
}

/// Obstacles of one cell and now and then a wall, on a floor as wide as a building.
FloorBox scatter_obstacles(FloorGrid& floor, Random& random) {
  FloorBox changed;
  const int left = static_cast<int>(random.index(360)), low = static_cast<int>(random.index(60));
  const int wall_y = low + static_cast<int>(random.index(80));
  for (int y = low; y < low + 40; ++y) {
    for (int x = left; x < left + 40; ++x) {
      const bool stands = y == wall_y || random.uniform() < 0.004;
      floor.set({x, y}, stands ? Floor::kOccupied : Floor::kFree);
      changed.include({x, y});
    }
  }
  return changed;
}

RC_GTEST_PROP(LegBarriers, AreTheSameWhetherSeenAtOnceOrBitByBit, (std::uint64_t seed)) {
  Random random(seed);
  FloorGrid floor;
  LegBarriers bit_by_bit;
  for (int round = 0; round < 15; ++round) {
    const LegBarriers before = bit_by_bit;
    const FloorBox turned = bit_by_bit.update(floor, scatter_obstacles(floor, random));
    FloorBox differ;
    const auto note_closed = [&](const LegBarriers& by, const LegBarriers& not_by) {
      for (const FloorCell cell : by.closed()) {
        if (!not_by.is_closed(cell)) differ.include(cell);
      }
    };
    note_closed(before, bit_by_bit);
    note_closed(bit_by_bit, before);
    RC_ASSERT(differ.low == turned.low && differ.end == turned.end);
  }
  LegBarriers at_once;
  at_once.update(floor, floor.known());
  RC_ASSERT(at_once.legs() == bit_by_bit.legs());
  for (int y = 0; y < 100; ++y) {
    for (int x = 0; x < 400; ++x) RC_ASSERT(at_once.is_closed({x, y}) == bit_by_bit.is_closed({x, y}));
  }
}

TEST(LegBarriers, ReduceTheClearanceBetweenLegs) {
  FloorGrid floor;
  for (int y = 0; y < 80; ++y) {
    for (int x = 0; x < 80; ++x) floor.set({x, y}, Floor::kFree);
  }
  floor.set({20, 40}, Floor::kOccupied);
  FloorClearance clearance(LegParams{});
  clearance.update(floor, floor.known());
  floor.set({50, 40}, Floor::kOccupied);
  FloorBox changed;
  changed.include({50, 40});
  clearance.update(floor, changed);
  EXPECT_EQ(clearance.to_occupied_m({35, 40}), 0);
  EXPECT_EQ(clearance.to_doubtful_m({35, 40}), 0);
  EXPECT_NEAR(clearance.to_occupied_m({35, 45}), 0.225, 1e-6);
}

}  // namespace
}  // namespace aisle
