#include "aisle/maps/wall_extension.hpp"

#include <gtest/gtest.h>

namespace aisle {
namespace {

/// A wall along x from 0 to 2 m, its free side above it, and a floor of cells of 5 cm.
class WallExtension : public testing::Test {
 protected:
  WallExtension() {
    map_.walls.push_back({.segment = {{0, 0}, {2, 0}}, .start = WallEnd::kSeen, .end = WallEnd::kSeen});
    strike(0, 2, 1);
  }

  /// Every n-th cell that the wall's line passes over.
  void strike(double from_m, double to_m, int every) {
    const FloorCell first = floor_.cell_at(Vec2(from_m + 0.02, 0.01)),
                    last = floor_.cell_at(Vec2(to_m - 0.02, 0.01));
    for (int x = first.x; x <= last.x; x += every) floor_.set({x, first.y}, Floor::kOccupied);
  }

  const Wall& extended() {
    extend_walls(map_, floor_);
    return map_.walls.front();
  }

  WallMap map_;
  FloorGrid floor_;
};

TEST_F(WallExtension, AWallThatWasStruckHereAndThereGoesOn) {
  strike(2, 3, 2);
  const Wall& wall = extended();
  EXPECT_NEAR(wall.segment.end.x(), 3, 0.1);
  EXPECT_EQ(wall.segment.end.y(), 0);
  EXPECT_EQ(wall.end, WallEnd::kUnknown);
  EXPECT_EQ(wall.segment.start, Vec2(0, 0));
  EXPECT_EQ(wall.start, WallEnd::kSeen);
}

TEST_F(WallExtension, BothEndsDo) {
  strike(-1, 0, 2);
  strike(2, 3, 2);
  const Wall& wall = extended();
  EXPECT_NEAR(wall.segment.start.x(), -1, 0.1);
  EXPECT_NEAR(wall.segment.end.x(), 3, 0.1);
}

TEST_F(WallExtension, ADoorwayEndsIt) {
  strike(2.8, 4, 1);
  EXPECT_EQ(extended().segment.end, Vec2(2, 0));
}

TEST_F(WallExtension, AFewSpecksAreNoWall) {
  strike(2.2, 4, 5);
  EXPECT_EQ(extended().segment.end, Vec2(2, 0));
}

TEST_F(WallExtension, AnotherWallOnItsLineIsNotItsOwn) {
  strike(2, 4, 1);
  map_.walls.push_back({.segment = {{2, 0}, {4, 0}}});
  EXPECT_EQ(extended().segment.end, Vec2(2, 0));
}

TEST_F(WallExtension, ACornerEndsIt) {
  for (int y = -20; y < 20; ++y) floor_.set({40, y}, Floor::kOccupied);
  map_.walls.push_back({.segment = {{2.02, 1}, {2.02, -1}}});
  EXPECT_EQ(extended().segment.end, Vec2(2, 0));
}

}  // namespace
}  // namespace aisle
