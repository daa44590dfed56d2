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

TEST(FloorGrid, DoesNotClearOccupiedCellsUnderTheVehicle) {
  FloorGrid floor;
  floor.set({3, 4}, Floor::kOccupied);
  floor.stand_on({3, 4});
  EXPECT_EQ(floor.at(FloorCell{3, 4}), Floor::kOccupied);
}

}  // namespace
}  // namespace aisle
