#include <gmock/gmock.h>

#include <algorithm>

#include "aisle/simulation/vertical_edges.hpp"

namespace aisle {
namespace {

using testing::Each;
using testing::Field;
using testing::IsEmpty;
using testing::SizeIs;

using EdgeKind = VerticalEdgeKind;

bool has_edge(const std::vector<VerticalEdge>& edges, EdgeKind kind, const Vec2& p) {
  return std::any_of(edges.begin(), edges.end(), [&](const VerticalEdge& edge) {
    return edge.kind == kind && (edge.p_world - p).norm() < 1e-9;
  });
}

WallFace wall(const Vec2& start, const Vec2& end) {
  return {.floor_edge = {start, end}};
}

TEST(VerticalEdges, AnEmptyWorldHasNone) {
  EXPECT_THAT(vertical_edges({}), IsEmpty());
}

TEST(VerticalEdges, ARoomHasOneInEachCornerAndNoneWhereAWallGoesStraightOn) {
  World room;
  room.walls = {wall({0, 0}, {2, 0}), wall({2, 0}, {5, 0}), wall({5, 0}, {5, 3}), wall({5, 3}, {0, 3}),
                wall({0, 3}, {0, 0})};
  const auto edges = vertical_edges(room);
  EXPECT_THAT(edges, SizeIs(4));
  EXPECT_THAT(edges, Each(Field(&VerticalEdge::kind, EdgeKind::kWall)));
  for (const Vec2& corner : {Vec2(0, 0), Vec2(5, 0), Vec2(5, 3), Vec2(0, 3)})
    EXPECT_TRUE(has_edge(edges, EdgeKind::kWall, corner));
}

TEST(VerticalEdges, AWallThatEndsFreelyAndOneThatGetsLowerAreSeen) {
  World world;
  world.walls = {wall({0, 0}, {2, 0}), wall({2, 0}, {4, 0})};
  world.walls[1].height_m = 1.2;
  EXPECT_THAT(vertical_edges(world), SizeIs(3));
  EXPECT_TRUE(has_edge(vertical_edges(world), EdgeKind::kWall, {2, 0}));
}

TEST(VerticalEdges, AClosedDoorIsItsTwoPosts) {
  World world;
  world.doors = {{.hinge = {1, 0}, .width_m = 0.9, .frame_width_m = 0.08}};
  const auto edges = vertical_edges(world);
  EXPECT_THAT(edges, SizeIs(2 * 4));
  EXPECT_THAT(edges, Each(Field(&VerticalEdge::kind, EdgeKind::kDoorFrame)));
  for (const double x : {1 - 0.08, 1 + 0.01, 1.9 - 0.01, 1.9 + 0.08}) {
    EXPECT_TRUE(has_edge(edges, EdgeKind::kDoorFrame, {x, 0.025})) << x;
    EXPECT_TRUE(has_edge(edges, EdgeKind::kDoorFrame, {x, -0.025})) << x;
  }
}

TEST(VerticalEdges, AnOpenDoorsLeafStandsInTheRoom) {
  World world;
  world.doors = {{.hinge = {1, 0}, .open_rad = kPi / 2, .width_m = 0.9}};
  const auto edges = vertical_edges(world);
  EXPECT_TRUE(has_edge(edges, EdgeKind::kDoorLeaf, {1.02, 0.9}));
  EXPECT_TRUE(has_edge(edges, EdgeKind::kDoorLeaf, {0.98, 0.9}));
}

TEST(VerticalEdges, ADoorWithoutAFrameIsItsLeaf) {
  World world;
  world.doors = {{.hinge = {1, 0}, .width_m = 0.9, .frame_width_m = 0}};
  EXPECT_THAT(vertical_edges(world), Each(Field(&VerticalEdge::kind, EdgeKind::kDoorLeaf)));
  EXPECT_TRUE(has_edge(vertical_edges(world), EdgeKind::kDoorLeaf, {1.9, 0.02}));
}

TEST(VerticalEdges, APosterHasASideToTheLeftAndOneToTheRight) {
  World world;
  world.posters = {{.centre = {3, 2}, .facing_rad = kPi / 2, .width_m = 0.6}};
  const auto edges = vertical_edges(world);
  EXPECT_THAT(edges, SizeIs(2));
  EXPECT_TRUE(has_edge(edges, EdgeKind::kPoster, {2.7, 2}));
  EXPECT_TRUE(has_edge(edges, EdgeKind::kPoster, {3.3, 2}));
}

TEST(VerticalEdges, FurnitureHasItsCornersWhereItStandsTurned) {
  World world;
  world.furniture = {{.centre = {1, 1}, .size = {0.8, 0.4}, .heading_rad = kPi / 2}};
  const auto edges = vertical_edges(world);
  EXPECT_THAT(edges, SizeIs(4));
  EXPECT_TRUE(has_edge(edges, EdgeKind::kFurniture, {1.2, 1.4}));
  EXPECT_TRUE(has_edge(edges, EdgeKind::kFurniture, {0.8, 0.6}));
}

}  // namespace
}  // namespace aisle
