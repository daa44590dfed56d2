#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "aisle/core/random.hpp"
#include "aisle/simulation/obstacles.hpp"
#include "plain_vehicles.hpp"

namespace aisle {
namespace {

World wall_at(double x) {
  World world;
  world.walls.push_back({.floor_edge = {{x, -5}, {x, 5}}});
  return world;
}

TEST(Footprint, IsTouchedByWhatCrossesItOrLiesInIt) {
  EXPECT_TRUE(intersects(kCart, {{0.5, -5}, {0.5, 5}}));
  EXPECT_TRUE(intersects(kCart, {{0.4, 0.1}, {0.5, 0.1}}));
  EXPECT_TRUE(intersects(kCart, {{0.9, 0.45}, {1.1, 0.1}}));
  EXPECT_FALSE(intersects(kCart, {{0.95, 0.5}, {1.2, 0.1}}));  // passes the corner
  EXPECT_FALSE(intersects(kCart, {{1.01, -5}, {1.01, 5}}));
  EXPECT_FALSE(intersects(kCart, {{-0.21, 0}, {-3, 0}}));
}

RC_GTEST_PROP(Footprint, IsTouchedWhereAPointOfTheSegmentIsInside, (std::uint64_t seed)) {
  Random random(seed);
  const auto any = [&] { return Vec2(random.uniform(-2, 2), random.uniform(-2, 2)); };
  const Segment2 segment{any(), any()};
  bool is_inside = false, is_near = false;
  for (int i = 0; i <= 1000; ++i) {
    const double off_m = distance_to(kCart, segment.start + i / 1000.0 * (segment.end - segment.start));
    is_inside = is_inside || off_m == 0;
    is_near = is_near || off_m < 0.01;
  }
  if (is_inside) RC_ASSERT(intersects(kCart, segment));
  if (!is_near) RC_ASSERT(!intersects(kCart, segment));
}

TEST(Obstacles, AnArcIsFreeUpToTheWall) {
  Obstacles obstacles(wall_at(3), kCart);
  EXPECT_NEAR(obstacles.free_share({}, {4, 0}), 0.5, 1e-4);
  EXPECT_EQ(obstacles.free_share({}, {1.99, 0}), 1);
  EXPECT_EQ(obstacles.free_share({}, {-20, 0}), 1);
}

TEST(Obstacles, TurningSweepsTheCorners) {
  Obstacles obstacles(wall_at(1.02), kCart);  // the front corners are 1.044 m away
  EXPECT_EQ(obstacles.free_share({}, {0, 0.05}), 1);
  EXPECT_LT(obstacles.free_share({}, {0, 0.3}), 1);
}

TEST(Obstacles, WhatIsAboveTheVehicleIsNoObstacle) {
  World world;
  world.furniture.push_back(
      {.kind = Furniture::Kind::kTable, .centre = {3, 0}, .size = {2, 2}, .height_m = 0.75});
  Footprint low = kCart;
  low.height_m = 0.25;
  EXPECT_EQ(Obstacles(world, low).free_share({}, {5, 0}), 1);
  EXPECT_LT(Obstacles(world, kCart).free_share({}, {5, 0}), 1);
}

TEST(Obstacles, AreFoundFarFromWhereItWasLookedBefore) {
  Obstacles obstacles(wall_at(50), kCart);
  EXPECT_EQ(obstacles.free_share({}, {1, 0}), 1);
  EXPECT_NEAR(obstacles.free_share({40, 0, 0}, {18, 0}), 0.5, 1e-4);
  obstacles.set_movers({{{2, -1}, {2, 1}}});
  EXPECT_NEAR(obstacles.free_share({}, {2, 0}), 0.5, 1e-3);
}

/// A wall so thin and a step so long that end poses alone would not show it.
RC_GTEST_PROP(Obstacles, NothingIsSteppedOver, (std::uint64_t seed)) {
  Random random(seed);
  Obstacles obstacles(wall_at(random.uniform(1.1, 20)), kCart);
  RC_ASSERT(obstacles.free_share({}, {random.uniform(21, 40), 0}) < 1);
}

}  // namespace
}  // namespace aisle
