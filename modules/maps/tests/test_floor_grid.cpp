#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <stdexcept>
#include <utility>

#include "aisle/core/random.hpp"
#include "aisle/maps/floor_grid.hpp"

namespace aisle {
namespace {

TEST(FloorGrid, IsUnknownWhereNothingWasSeen) {
  const FloorGrid grid(0.05);
  EXPECT_EQ(grid.at(Vec2(3, -4)), Floor::kUnknown);
  EXPECT_TRUE(grid.known().empty());
  EXPECT_EQ(grid.free_m2(), 0);
}

TEST(FloorGrid, CellsAreCountedFromTheOriginInBothDirections) {
  const FloorGrid grid(0.1);
  EXPECT_EQ(grid.cell_at({0.05, 0.05}), (FloorCell{0, 0}));
  EXPECT_EQ(grid.cell_at({-0.05, 0.25}), (FloorCell{-1, 2}));
  EXPECT_LT((grid.centre({-1, 2}) - Vec2(-0.05, 0.25)).norm(), 1e-12);
}

TEST(FloorGrid, OneHitOutweighsAFewViewsThatPass) {
  FloorGrid grid;
  const FloorCell cell{1, 1};
  EXPECT_TRUE(grid.see_occupied(cell));
  for (int i = 0; i < 3; ++i) EXPECT_FALSE(grid.see_free(cell));
  EXPECT_EQ(grid.at(cell), Floor::kOccupied);
}

TEST(FloorGrid, WhatHasGoneAwayFades) {
  FloorGrid grid;
  const FloorCell cell{1, 1};
  for (int i = 0; i < 1000; ++i) grid.see_occupied(cell);
  for (int i = 0; i < 20; ++i) grid.see_free(cell);
  EXPECT_EQ(grid.at(cell), Floor::kFree);
}

TEST(FloorGrid, NeverGrowsBeyondItsReach) {
  FloorGrid grid;
  EXPECT_FALSE(grid.see_occupied({FloorGrid::kReach + 1, 0}));
  EXPECT_EQ(grid.at(grid.cell_at({1e300, -1e300})), Floor::kUnknown);
}

TEST(FloorGrid, NeedsACellSize) {
  EXPECT_THROW(FloorGrid(0), std::invalid_argument);
}

RC_GTEST_PROP(FloorGrid, HoldsWhatWasPutWhereverItGrew, (std::uint64_t seed)) {
  Random random(seed);
  FloorGrid grid(0.05);
  std::map<std::pair<int, int>, Floor> put;
  for (int i = 0; i < 200; ++i) {
    const FloorCell cell{static_cast<int>(random.normal(200)), static_cast<int>(random.normal(200))};
    const auto floor = static_cast<Floor>(random.index(3));
    grid.set(cell, floor);
    put[{cell.x, cell.y}] = floor;
  }
  std::size_t free = 0;
  for (const auto& [place, floor] : put) {
    const FloorCell cell{place.first, place.second};
    RC_ASSERT(grid.at(cell) == floor);
    RC_ASSERT(floor == Floor::kUnknown || grid.known().contains(cell));
    if (floor == Floor::kFree) ++free;
  }
  RC_ASSERT(grid.count(Floor::kFree) == free);
}

TEST(FloorBox, HoldsWhatItIncludesAndSharesWhatLiesInBoth) {
  FloorBox box{{0, 0}, {2, 2}};
  box.include_box({});
  EXPECT_EQ(box.end, (FloorCell{2, 2}));
  box.include_box({{5, 1}, {7, 2}});
  EXPECT_EQ(box.low, (FloorCell{0, 0}));
  EXPECT_EQ(box.end, (FloorCell{7, 2}));
  const FloorBox common = box.common_with({{6, -3}, {9, 1}});
  EXPECT_EQ(common.low, (FloorCell{6, 0}));
  EXPECT_EQ(common.end, (FloorCell{7, 1}));
  EXPECT_TRUE(box.common_with({{7, 0}, {8, 2}}).empty());
}

TEST(FloorGrid, KeepsWhereTheVehicleWasUntilSomethingIsHitThere) {
  FloorGrid floor;
  const FloorCell cell{3, 4};
  EXPECT_TRUE(floor.stand_on(cell));
  EXPECT_FALSE(floor.stand_on(cell));
  for (int i = 0; i < 20; ++i) floor.see_free(cell);
  EXPECT_TRUE(floor.was_stood_on(cell));
  EXPECT_EQ(floor.at(cell), Floor::kFree);
  floor.see_occupied(cell);
  EXPECT_FALSE(floor.was_stood_on(cell));
  for (int i = 0; i < 3; ++i) floor.see_occupied(cell);
  EXPECT_EQ(floor.at(cell), Floor::kOccupied);
}

/// Surely free, nothing near it.
FloorGrid free_floor(FloorCell cell) {
  FloorGrid floor;
  for (int i = 0; i < 10; ++i) floor.see_free(cell);
  return floor;
}

TEST(FloorGrid, ADynamicObstacleIsThereAtItsSecondHitAndGoesAsItCame) {
  const FloorCell cell{3, 4};
  FloorGrid floor = free_floor(cell);
  EXPECT_FALSE(floor.see_solid(cell));
  EXPECT_TRUE(floor.see_solid(cell));
  EXPECT_TRUE(floor.is_dynamic(cell));
  EXPECT_TRUE(floor.see_free(cell));
  EXPECT_FALSE(floor.see_free(cell));
  EXPECT_FALSE(floor.is_dynamic(cell));
  EXPECT_EQ(floor.at(cell), Floor::kFree);
}

TEST(FloorGrid, ADynamicObstacleThatIsNotSeenForAWhileIsForgotten) {
  const FloorCell cell{3, 4};
  FloorGrid floor = free_floor(cell);
  floor.pass_time(100);
  floor.see_solid(cell);
  floor.pass_time(101);
  floor.see_solid(cell);
  EXPECT_TRUE(floor.pass_time(101 + FloorGrid::kForgotten_s).empty());
  EXPECT_EQ(floor.at(cell), Floor::kOccupied);
  EXPECT_TRUE(floor.pass_time(101.1 + FloorGrid::kForgotten_s).contains(cell));
  EXPECT_EQ(floor.at(cell), Floor::kFree);
}

TEST(FloorGrid, WhatIsHitOftenHasComeToStay) {
  const FloorCell cell{3, 4};
  FloorGrid floor = free_floor(cell);
  for (int i = 0; i < 20; ++i) floor.see_solid(cell);
  EXPECT_TRUE(floor.is_dynamic(cell));
  floor.see_solid(cell);
  EXPECT_FALSE(floor.is_dynamic(cell));
  EXPECT_TRUE(floor.pass_time(1e9).empty());
  EXPECT_EQ(floor.at(cell), Floor::kOccupied);
}

TEST(FloorGrid, WhatStandsWhereNothingWasSeenBeforeIsNotDynamic) {
  FloorGrid floor;
  floor.see_solid({3, 4});
  EXPECT_FALSE(floor.is_dynamic({3, 4}));
  EXPECT_TRUE(floor.pass_time(1e9).empty());
}

/// Beside a wall, hits are its own, off by the noise.
TEST(FloorGrid, NothingIsDynamicAtAWallsEdge) {
  const FloorCell cell{3, 4};
  FloorGrid floor = free_floor(cell);
  floor.set({5, 4}, Floor::kOccupied);
  for (int hit = 0; hit < 3; ++hit) {
    EXPECT_EQ(floor.at(cell), Floor::kFree);
    floor.see_solid(cell);
    EXPECT_FALSE(floor.is_dynamic(cell));
  }
  EXPECT_EQ(floor.at(cell), Floor::kOccupied);
}

/// A pane sends back a beam now and then; the others pass it.
TEST(FloorGrid, SingleHitsCollectWhereTheFloorWasFree) {
  const FloorCell cell{3, 4};
  FloorGrid floor = free_floor(cell);
  for (int i = 0; i < 3; ++i) floor.see_occupied(cell);
  EXPECT_FALSE(floor.is_dynamic(cell));
  floor.pass_time(1e9);
  EXPECT_EQ(floor.at(cell), Floor::kOccupied);
}

/// Views from new places with beams farther apart make the floor free enough, others do not.
TEST(FloorGrid, WhatComesWhereViewsFromNewPlacesSawNothingIsDynamic) {
  FloorGrid floor;
  for (int i = 0; i < 10; ++i) {
    floor.fade({3, 4});
    floor.seem_free({9, 9});
  }
  floor.see_solid({3, 4});
  floor.see_solid({9, 9});
  EXPECT_TRUE(floor.is_dynamic({3, 4}));
  EXPECT_FALSE(floor.is_dynamic({9, 9}));
  EXPECT_EQ(floor.at(FloorCell{9, 9}), Floor::kOccupied);
}

/// What was hit but once or twice may be somebody, too: what comes beside it is not a wall's edge.
TEST(FloorGrid, OnlyWhatWasHitThriceStands) {
  const FloorCell cell{3, 4};
  FloorGrid floor = free_floor(cell);
  floor.see_occupied({4, 4});
  floor.see_occupied({4, 4});
  FloorGrid beside_standing = floor;
  beside_standing.see_occupied({4, 4});
  floor.see_solid(cell);
  beside_standing.see_solid(cell);
  EXPECT_TRUE(floor.is_dynamic(cell));
  EXPECT_FALSE(beside_standing.is_dynamic(cell));
}

/// Whatever happens to a few cells, the counts are those of the cells, and time frees only what has come.
RC_GTEST_PROP(FloorGrid, CountsItsCellsWhateverComesAndGoes, (std::uint64_t seed)) {
  Random random(seed);
  FloorGrid floor;
  double now_s = 0;
  for (int i = 0; i < 2000; ++i) {
    const FloorCell cell{static_cast<int>(random.index(4)) * 4, 0};
    switch (random.index(8)) {
      case 0:
        floor.see_occupied(cell);
        break;
      case 1:
        floor.seem_free(cell);
        break;
      case 2:
        floor.fade(cell);
        break;
      case 3:
        floor.stand_on(cell);
        break;
      case 4:
        floor.see_solid(cell);
        break;
      case 5:
        floor.pass_time(now_s += 3);
        break;
      default:
        floor.see_free(cell);
        break;
    }
    std::size_t occupied = 0;
    for (int x = 0; x < 16; ++x) occupied += floor.at(FloorCell{x, 0}) == Floor::kOccupied ? 1 : 0;
    RC_ASSERT(floor.count(Floor::kOccupied) == occupied);
  }
  FloorGrid later = floor;
  later.pass_time(now_s + 1.1 * FloorGrid::kForgotten_s);
  floor.forget_dynamic();
  for (int x = 0; x < 16; ++x) {
    RC_ASSERT(!floor.is_dynamic({x, 0}));
    RC_ASSERT(later.at(FloorCell{x, 0}) == floor.at(FloorCell{x, 0}));
  }
}

TEST(FloorGrid, DoesNotClearOccupiedCellsUnderTheVehicle) {
  FloorGrid floor;
  floor.set({3, 4}, Floor::kOccupied);
  floor.stand_on({3, 4});
  EXPECT_EQ(floor.at(FloorCell{3, 4}), Floor::kOccupied);
}

}  // namespace
}  // namespace aisle
