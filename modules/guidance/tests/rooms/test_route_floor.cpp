#include "aisle/guidance/rooms/route_floor.hpp"

#include <gmock/gmock.h>

#include <vector>

namespace aisle {
namespace {

const Footprint kFootprint{.front_m = 0.95, .rear_m = 0.25, .width_m = 0.6};

/// 5 m straight on, with a wall 1 m to the left, each point of which was last seen from 2 m before it.
FloorGrid floor_beside_wall(double reach_m) {
  std::vector<RouteEdge> edges;
  for (double x = 2; x < 6; x += 0.05) edges.push_back({x - 2, Vec2(x, 1)});
  return route_floor(Path(std::vector{PathPiece{{}, {5, 0}}}), edges, kFootprint, {4, 0}, reach_m);
}

TEST(RouteFloor, IsFreeWhereTheVehicleDroveAndUpToTheEdgesThatItSaw) {
  const FloorGrid floor = floor_beside_wall(4);
  EXPECT_EQ(floor.at(Vec2(3, 0)), Floor::kFree);
  EXPECT_EQ(floor.at(Vec2(3, -0.6)), Floor::kFree);
  EXPECT_EQ(floor.at(Vec2(4, 0.9)), Floor::kFree);
  EXPECT_EQ(floor.at(Vec2(4, 1)), Floor::kOccupied);
}

TEST(RouteFloor, IsUnknownBehindEdgesAndWhereNothingWasSeen) {
  const FloorGrid floor = floor_beside_wall(4);
  EXPECT_EQ(floor.at(Vec2(4, 1.3)), Floor::kUnknown);
  EXPECT_EQ(floor.at(Vec2(4, -1.2)), Floor::kUnknown);
}

TEST(RouteFloor, IsUnknownFarFromThePlace) {
  EXPECT_EQ(floor_beside_wall(1).at(Vec2(1, 0)), Floor::kUnknown);
}

TEST(RouteFloor, GivesTheShareOfThePathWhereTheVehicleDroveOverEdges) {
  const Path path(std::vector{PathPiece{{}, {4.9, 0}}});
  const std::vector<RouteEdge> edges = {{0, {1.2, 0.1}}, {0, {1.3, -0.2}}, {0, {2.2, 0}},
                                        {0, {3, 0.28}},  {0, {4, 1}},      {0, {6, 0}}};
  EXPECT_NEAR(share_with_edges_on_path(path, edges, kFootprint), 0.2, 1e-9);
}

TEST(RouteFloor, EndsAtUnknownCells) {
  FloorGrid floor(1);
  floor.set(FloorCell{0, 0}, Floor::kFree);
  for (int x = -1; x <= 1; ++x) floor.set(FloorCell{x, 1}, Floor::kOccupied);
  EXPECT_THAT(limit_of_known(floor),
              testing::UnorderedElementsAre(Vec2(-0.5, 0.5), Vec2(1.5, 0.5), Vec2(-0.5, -0.5),
                                            Vec2(0.5, -0.5), Vec2(1.5, -0.5)));
}

}  // namespace
}  // namespace aisle
