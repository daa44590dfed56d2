#include "sections/wall_keeping.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace aisle {
namespace {

constexpr double kSkirted_m = 1 + kSkirtingDepth_m;  // to a wall whose skirting board is a metre away

/// Along x, the wall to its right: with an alcove, 2 m of 10.
World corridor_with_alcove(double depth_m) {
  const double wall = -kSkirted_m;
  World world;
  world.skirting_height_m = 0.1;
  for (const Segment2& edge : {Segment2{{10, wall}, {6, wall}}, Segment2{{6, wall}, {6, wall - depth_m}},
                               Segment2{{6, wall - depth_m}, {4, wall - depth_m}},
                               Segment2{{4, wall - depth_m}, {4, wall}}, Segment2{{4, wall}, {0, wall}}})
    world.walls.push_back({.floor_edge = edge});
  return world;
}

ErrorFigure error_along(const World& world, double learned_m, double lateral_m) {
  WallKeeping keeping(world);
  for (int i = 0; i < 100; ++i) keeping.add(0, {0.05 + 0.1 * i, lateral_m, 0}, learned_m);
  return keeping.error_m();
}

TEST(WallKeeping, ComparesTheDistanceToTheSkirtingBoardWithTheLearnedOne) {
  const World world = corridor_with_alcove(0);
  EXPECT_NEAR(error_along(world, 1, 0).rms(), 0, 1e-9);
  EXPECT_NEAR(error_along(world, 0.97, 0).rms(), 0.03, 1e-9);
  EXPECT_NEAR(error_along(world, 1, 0.02).worst(), 0.02, 1e-9);
  EXPECT_EQ(error_along(world, 1, 0).count(), 100U);
}

TEST(WallKeeping, AnAlcoveIsNotTheWallThatADistanceIsKeptFrom) {
  for (const double depth_m : {0.1, 0.2, 1.0}) {
    const ErrorFigure error_m = error_along(corridor_with_alcove(depth_m), 0.99, 0);
    EXPECT_NEAR(error_m.worst(), 0.01, 1e-9);
    EXPECT_EQ(error_m.count(), 80U);
  }
}

TEST(WallKeeping, WallsOfOneLineMayRunEitherWay) {
  World world = corridor_with_alcove(0.2);
  Segment2& last = world.walls.back().floor_edge;
  std::swap(last.start, last.end);
  EXPECT_EQ(error_along(world, 1, 0).count(), 80U);
}

TEST(WallKeeping, AWallThatStepsSidewaysByLittleCounts) {
  EXPECT_NEAR(error_along(corridor_with_alcove(0.04), 1, 0).worst(), 0.04, 1e-9);
}

TEST(WallKeeping, EachPieceOfAPathHasItsOwnWall) {
  WallKeeping keeping(corridor_with_alcove(0.2));
  for (const double x : {1.0, 2.0, 3.0}) keeping.add(0, {x, 0, 0}, 1);
  for (const double x : {4.5, 5.0, 5.5}) keeping.add(1, {x, 0, 0}, 1.17);
  EXPECT_EQ(keeping.error_m().count(), 6U);
  EXPECT_NEAR(keeping.error_m().worst(), 0.03, 1e-9);
}

}  // namespace
}  // namespace aisle
