#include "aisle/maps/grazing_walls.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

/// A wall along x from 0 to 2 m, its free side above it, and a floor of cells of 5 cm.
class GrazingWalls : public testing::Test {
 protected:
  GrazingWalls() {
    map_.walls.push_back({.segment = {{0, 0}, {2, 0}}, .start = WallEnd::kSeen, .end = WallEnd::kSeen});
    strike(0, 2, 1);
  }

  /// Every n-th cell that the wall's line passes over.
  void strike(double from_m, double to_m, int every) {
    const FloorCell first = floor_.cell_at(Vec2(from_m + 0.02, 0.01)),
                    last = floor_.cell_at(Vec2(to_m - 0.02, 0.01));
    for (int x = first.x; x <= last.x; x += every) floor_.set({x, first.y}, Floor::kOccupied);
  }

  void draw() { draw_grazing_walls(map_, floor_); }
  const Wall& extended() {
    draw();
    return map_.walls.front();
  }

  void put_free(FloorCell low, FloorCell end) {
    for (int y = low.y; y < end.y; ++y) {
      for (int x = low.x; x < end.x; ++x) floor_.set({x, y}, Floor::kFree);
    }
  }

  WallMap map_;
  FloorGrid floor_;
};

TEST_F(GrazingWalls, AWallThatWasHitHereAndThereGoesOn) {
  strike(2, 3, 2);
  const Wall& wall = extended();
  EXPECT_NEAR(wall.segment.end.x(), 3, 0.1);
  EXPECT_EQ(wall.segment.end.y(), 0);
  EXPECT_EQ(wall.end, WallEnd::kUnknown);
  EXPECT_EQ(wall.segment.start, Vec2(0, 0));
  EXPECT_EQ(wall.start, WallEnd::kSeen);
}

TEST_F(GrazingWalls, BothEndsDo) {
  strike(-1, 0, 2);
  strike(2, 3, 2);
  const Wall& wall = extended();
  EXPECT_NEAR(wall.segment.start.x(), -1, 0.1);
  EXPECT_NEAR(wall.segment.end.x(), 3, 0.1);
}

TEST_F(GrazingWalls, ADoorwayEndsIt) {
  strike(2.8, 4, 1);
  EXPECT_EQ(extended().segment.end, Vec2(2, 0));
}

TEST_F(GrazingWalls, AFewSpecksAreNoWall) {
  strike(2.2, 4, 5);
  EXPECT_EQ(extended().segment.end, Vec2(2, 0));
}

TEST_F(GrazingWalls, AnotherWallOnItsLineIsNotItsOwn) {
  strike(2, 4, 1);
  map_.walls.push_back({.segment = {{2, 0}, {4, 0}}});
  EXPECT_EQ(extended().segment.end, Vec2(2, 0));
}

TEST_F(GrazingWalls, ACornerEndsIt) {
  for (int y = -20; y < 20; ++y) floor_.set({40, y}, Floor::kOccupied);
  map_.walls.push_back({.segment = {{2.02, 1}, {2.02, -1}}});
  EXPECT_EQ(extended().segment.end, Vec2(2, 0));
}

TEST_F(GrazingWalls, ARowOfHitCellsBesideFreeFloorIsAWallThatIsSeenFromThere) {
  put_free({-10, 60}, {40, 80});
  for (int x = 0; x < 24; x += 2) floor_.set({x, 80}, Floor::kOccupied);
  draw();
  ASSERT_EQ(map_.walls.size(), 2U);
  const Wall& wall = map_.walls.back();
  EXPECT_TRUE(wall.is_orthogonal);
  EXPECT_NEAR(wall.segment.start.x(), 1.15, 0.05);
  EXPECT_NEAR(wall.segment.end.x(), 0, 0.05);
  EXPECT_NEAR(wall.segment.start.y(), 4.025, 1e-9);
  EXPECT_NEAR(wall.segment.end.y(), 4.025, 1e-9);
  EXPECT_EQ(wall.start, WallEnd::kUnknown);
  EXPECT_EQ(wall.sightings, 1);
}

TEST_F(GrazingWalls, WithNoFreeFloorBesideItARowIsNoWall) {
  for (int x = 0; x < 24; x += 2) floor_.set({x, 80}, Floor::kOccupied);
  draw();
  EXPECT_EQ(map_.walls.size(), 1U);
}

TEST_F(GrazingWalls, ShortRowsAndLegsAreNoWalls) {
  put_free({-10, 60}, {40, 100});
  for (int x = 0; x < 5; ++x) floor_.set({x, 80}, Floor::kOccupied);
  for (int x = 12; x < 40; x += 7) floor_.set({x, 80}, Floor::kOccupied);
  draw();
  EXPECT_EQ(map_.walls.size(), 1U);
}

TEST_F(GrazingWalls, ObliqueRowsAreParallelToTheWallNearby) {
  const Vec2 along = unit(0.3), across = left_normal(along);
  map_.walls.push_back({.segment = {{0, 6}, Vec2(0, 6) + along}});
  put_free({-10, 100}, {60, 160});
  for (int i = 0; i < 12; ++i)
    floor_.set(floor_.cell_at(Vec2(0, 6) + 0.1 * (i + 0.5) * across - 0.1 * along), Floor::kOccupied);
  draw();
  ASSERT_EQ(map_.walls.size(), 3U);
  EXPECT_FALSE(map_.walls.back().is_orthogonal);
  EXPECT_NEAR(std::abs(std::remainder(map_.walls.back().segment.heading() - 0.3, kPi)), kPi / 2, 1e-9);
}

}  // namespace
}  // namespace aisle
