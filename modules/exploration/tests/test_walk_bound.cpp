#include "aisle/exploration/walk_bound.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "aisle/exploration/exploration_run.hpp"
#include "worlds.hpp"

namespace aisle {
namespace {

TEST(WalkBound, IsTwiceTheEdgesOfATree) {
  const GridWorld world = generate_maze({.kind = MazeKind::kPerfect, .width = 30, .height = 20}, Random(1));
  EXPECT_EQ(walk_lower_bound(world, {3, 4}), 2U * (600 - 1));
}

TEST(WalkBound, CountsEachBlockByItself) {
  // A ring of four, a bridge, another ring of four.
  const GridWorld world = world_of({{"rb", "lb", "rb", "lb"}, {"rt", "lrt", "lrt", "lt"}});
  EXPECT_EQ(walk_lower_bound(world, {0, 0}), 4U + 2U + 4U);
  EXPECT_EQ(shortest_walk(world, {0, 0}), 10U);
}

TEST(WalkBound, OfAnOddHallCountsTheMoreFrequentColor) {
  const GridWorld world = generate_maze({.kind = MazeKind::kHall, .width = 3, .height = 3}, Random(1));
  EXPECT_EQ(walk_lower_bound(world, {0, 0}), 10U);
  EXPECT_EQ(shortest_walk(world, {0, 0}), 10U);
}

TEST(WalkBound, OneCellNeedsNoMoves) {
  EXPECT_EQ(walk_lower_bound(GridWorld(1, 1), {0, 0}), 0U);
  EXPECT_EQ(shortest_walk(GridWorld(1, 1), {0, 0}), 0U);
}

RC_GTEST_PROP(WalkBound, IsNeverAboveTheShortestWalk, ()) {
  const GridWorld world = random_world(4);
  const auto shortest = shortest_walk(world, world.start);
  RC_ASSERT(shortest.has_value());
  RC_ASSERT(walk_lower_bound(world, world.start) <= *shortest);
  SilentProgress progress;
  RC_ASSERT(explore_nearest_first(world, world.start, progress).figures.moves >= *shortest);
  RC_ASSERT(explore_nearest_first(world, world.start, progress).figures.complete());
}

}  // namespace
}  // namespace aisle
