#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "aisle/exploration/maze_generator.hpp"
#include "aisle/simulation/buildings/maze_building.hpp"
#include "aisle/simulation/paths/round_trip.hpp"
#include "plan_raster.hpp"

namespace aisle {
namespace {

constexpr MazeBuildingParams kParams{.corridor_width_m = 1.8, .wall_thickness_m = 0.2};

double area_m2(const World& world) {
  double area = 0;
  for (const WallFace& wall : world.walls) {
    area += (wall.floor_edge.start.x() * wall.floor_edge.end.y() -
             wall.floor_edge.start.y() * wall.floor_edge.end.x()) /
            2;
  }
  return area;
}

TEST(MazeBuilding, TwoOpenCellsAreOneCorridor) {
  GridWorld maze(2, 1);
  maze.set_open({0, 0}, Side::kRight, true);
  const World world = build_maze(maze, kParams);
  EXPECT_EQ(world.walls.size(), 4);
  EXPECT_NEAR(area_m2(world), 3.8 * 1.8, 1e-9);
  EXPECT_NEAR(world.start->x, 0.9, 1e-9);
  EXPECT_NEAR(world.start->theta, 0, 1e-9);
}

TEST(MazeBuilding, AWallBetweenCellsHasItsThickness) {
  GridWorld maze(2, 2);
  for (const Side side : {Side::kRight, Side::kTop}) maze.set_open({0, 0}, side, true);
  maze.set_open({0, 1}, Side::kRight, true);
  EXPECT_EQ(build_maze(maze, kParams).walls.size(), 8) << "a U of three legs";
}

TEST(MazeBuilding, CellsThatCannotBeReachedAreSolidAndLonelyPostsAreLeftOut) {
  GridWorld maze(3, 2);
  maze.set_open({0, 0}, Side::kRight, true);
  maze.set_open({0, 0}, Side::kTop, true);
  maze.set_open({0, 1}, Side::kRight, true);
  maze.set_open({1, 0}, Side::kTop, true);
  const World world = build_maze(maze, kParams);
  EXPECT_EQ(world.walls.size(), 4);
  EXPECT_NEAR(area_m2(world), 3.8 * 3.8, 1e-9);
}

TEST(MazeBuilding, GoalsArePlaces) {
  GridWorld maze(4, 1);
  for (int x = 0; x < 3; ++x) maze.set_open({x, 0}, Side::kRight, true);
  maze.goals = {{3, 0}, {2, 0}};
  const World world = build_maze(maze, kParams);
  ASSERT_EQ(world.places.size(), 2);
  EXPECT_EQ(world.places[1].name, "goal 2");
  EXPECT_NEAR(world.places[0].T_world_place.x, 6.9, 1e-9);
}

RC_GTEST_PROP(MazeBuilding, ATourComesIntoEveryCell, ()) {
  const auto kind = *rc::gen::elementOf(std::vector<MazeKind>(std::begin(kMazeKinds), std::end(kMazeKinds)));
  const MazeRecipe recipe{.kind = kind, .width = *rc::gen::inRange(2, 7), .height = *rc::gen::inRange(2, 7)};
  const GridWorld maze = generate_maze(recipe, Random(*rc::gen::arbitrary<std::uint32_t>()));
  World world = build_maze(maze, kParams);
  SilentProgress silent;
  const auto run = plan_round_trip(world, {}, silent);
  RC_ASSERT(run.has_value());
  RC_ASSERT((run->tour.front() - world.start->position()).norm() < 0.05);
  RC_ASSERT(run->tour.front() == run->tour.back());
  for (std::size_t cell = 0; cell < maze.size(); ++cell) {
    if (!reachable_cells(maze, maze.start)[cell]) continue;
    const Vec2 centre = Vec2(maze.cell(cell).x * 2.0 + 0.9, maze.cell(cell).y * 2.0 + 0.9);
    double nearest_m = 1e9;
    for (std::size_t i = 1; i < run->tour.size(); ++i) {
      const Vec2 start = run->tour[i - 1], step = run->tour[i] - start;
      const double share = std::clamp((centre - start).dot(step) / step.squaredNorm(), 0.0, 1.0);
      nearest_m = std::min(nearest_m, (start + share * step - centre).norm());
    }
    RC_ASSERT(nearest_m < 2.3);
  }
}

}  // namespace
}  // namespace aisle
