#include "aisle/exploration/maze_generator.hpp"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <bit>
#include <stdexcept>

#include "worlds.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;

std::size_t open_edges(const GridWorld& world) {
  std::size_t ends = 0;
  for (std::size_t cell = 0; cell < world.size(); ++cell)
    ends += std::popcount(static_cast<unsigned>(world.open(cell)));
  return ends / 2;
}

bool is_connected(const GridWorld& world) {
  const auto reached = reachable_cells(world, {0, 0});
  return std::count(reached.begin(), reached.end(), true) == static_cast<std::ptrdiff_t>(world.size());
}

RC_GTEST_PROP(MazeGenerator, MakesTreesOfPerfectMazes, ()) {
  const GridWorld world =
      generate_maze({MazeKind::kPerfect, *rc::gen::inRange(1, 40), *rc::gen::inRange(1, 40)},
                    Random(*rc::gen::arbitrary<std::uint64_t>()));
  RC_ASSERT(is_connected(world));
  RC_ASSERT(open_edges(world) == world.size() - 1);
}

RC_GTEST_PROP(MazeGenerator, ReachesEveryCellOfMostKinds, ()) {
  const auto kind =
      *rc::gen::element(MazeKind::kBraided, MazeKind::kRooms, MazeKind::kSpiral, MazeKind::kHall);
  RC_ASSERT(is_connected(generate_maze({kind, *rc::gen::inRange(1, 40), *rc::gen::inRange(1, 40)},
                                       Random(*rc::gen::arbitrary<std::uint64_t>()))));
}

TEST(MazeGenerator, OpensMoreDeadEndsForALargerLoopShare) {
  const auto edges = [](double share) {
    return open_edges(generate_maze({MazeKind::kBraided, 50, 50, share}, Random(1)));
  };
  EXPECT_EQ(edges(0), 2499U);
  EXPECT_LT(edges(0.3), edges(1));
}

TEST(MazeGenerator, WindsOneCorridorToTheMiddle) {
  const GridWorld spiral = generate_maze({MazeKind::kSpiral, 5, 5}, Random(1));
  EXPECT_EQ(open_edges(spiral), 24U);
  EXPECT_EQ(std::popcount(static_cast<unsigned>(spiral.open({2, 2}))), 1);
}

TEST(MazeGenerator, FindsTheMiddle) {
  EXPECT_THAT(middle_cells(GridShape(3, 3)), ElementsAre(Cell{1, 1}));
  EXPECT_THAT(middle_cells(GridShape(16, 16)), ElementsAre(Cell{7, 7}, Cell{8, 7}, Cell{7, 8}, Cell{8, 8}));
  EXPECT_THAT(middle_cells(GridShape(2, 1)), ElementsAre(Cell{0, 0}, Cell{1, 0}));
}

TEST(GridWorld, RefusesSizesAndEdgesThatDoNotExist) {
  EXPECT_THROW(GridWorld(0, 1), std::invalid_argument);
  EXPECT_THROW(GridWorld(1, 4097), std::invalid_argument);
  EXPECT_THROW(GridWorld(2, 2).set_open({0, 0}, Side::kLeft, true), std::invalid_argument);
}

TEST(GridWorld, KeepsBothSidesOfAnEdgeTheSame) {
  GridWorld world(2, 2);
  world.set_open({0, 1}, Side::kBottom, true);
  EXPECT_EQ(world.open({0, 0}), bit(Side::kTop));
  world.set_open({0, 0}, Side::kTop, false);
  EXPECT_EQ(world.open({0, 1}), kNoSides);
  world.open_all();
  EXPECT_EQ(world.open({1, 1}), bit(Side::kLeft) | bit(Side::kBottom));
}

}  // namespace
}  // namespace aisle
