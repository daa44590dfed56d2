#include <gmock/gmock.h>

#include "aisle/merging/moved_building.hpp"
#include "drawn_building.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

constexpr Pose2 kQuarterTurn{10, 5, kPi / 2};

Building furnished() {
  Building building = drawn::known(drawn::Plan({drawn::rect(0, 0, 8, 4)}));
  building.places = {{"lift", {1, 2, 0}}, {"lab", {1, 2, 0}, false}};
  building.zones = {{.kind = Zone::Kind::kOneWay, .outline = {{1, 1}, {2, 1}, {2, 2}}, .direction_rad = 0}};
  building.barriers = {{Barrier::Kind::kGlass, {{3, 0}, {3, 4}}}};
  building.landmarks.add({.p_map = {4, 1}, .covariance = Vec2(4e-4, 1e-4).asDiagonal(), .seen_from = {1, 0}});
  building.routes.push_back({.name = "round", .path = Path(std::vector{PathPiece{{1, 1, 0}, {2, kPi / 2}}})});
  building.routes[0].room = RoomRoute{.edges = {{0, {1, 0}}}};
  building.wall_directions = {{{2, 2}, 10 * kDegree, kDegree}};
  building.corridors.nodes = {{CorridorNode::Kind::kEnd, {1, 2}}, {CorridorNode::Kind::kEnd, {7, 2}}};
  building.corridors.corridors = {{0, 1, {{1, 2}, {7, 2}}, 4}};
  return building;
}

TEST(MovedBuilding, EverythingMovesWithIt) {
  const Building moved = moved_building(furnished(), kQuarterTurn);
  EXPECT_THAT(moved.places[0].T_map_place, PoseNear(Pose2{8, 6, kPi / 2}, 1e-9, 1e-9));
  EXPECT_THAT(moved.places[1].T_map_place, PoseNear(Pose2{8, 6, 0}, 1e-9, 1e-9)) << "it has no heading";
  EXPECT_THAT(moved.zones[0].outline[0], PointNear(Vec2(9, 6), 1e-9));
  EXPECT_NEAR(moved.zones[0].direction_rad, kPi / 2, 1e-9);
  EXPECT_THAT(moved.barriers[0].segment.end, PointNear(Vec2(6, 8), 1e-9));
  EXPECT_THAT(moved.landmarks[0].p_map, PointNear(Vec2(9, 9), 1e-9));
  EXPECT_NEAR(moved.landmarks[0].covariance(1, 1), 4e-4, 1e-12);
  EXPECT_THAT(moved.landmarks[0].seen_from, PointNear(Vec2(0, 1), 1e-9));
  EXPECT_THAT(moved.routes[0].path.end(),
              PoseNear(kQuarterTurn * furnished().routes[0].path.end(), 1e-9, 1e-9));
  EXPECT_THAT(moved.routes[0].room->edges[0].p_map, PointNear(Vec2(10, 6), 1e-9));
  EXPECT_NEAR(moved.wall_directions[0].direction_rad, 10 * kDegree, 1e-9);
  EXPECT_THAT(moved.corridors.nodes[1].p_map, PointNear(Vec2(8, 12), 1e-9));
  EXPECT_THAT(moved.corridors.corridors[0].path[0], PointNear(Vec2(8, 6), 1e-9));
  EXPECT_TRUE(moved.walls.walls[0].is_orthogonal);
}

TEST(MovedBuilding, AWallTurnedOffTheAxesIsOblique) {
  const Building moved = moved_building(furnished(), {0, 0, 0.1});
  for (const Wall& wall : moved.walls.walls) EXPECT_FALSE(wall.is_orthogonal);
}

TEST(MovedFloor, AQuarterTurnByWholeCellsIsExact) {
  const FloorGrid floor = *furnished().floor;
  const FloorGrid back =
      moved_floor(moved_floor(floor, kQuarterTurn, floor.cell_m()), kQuarterTurn.inverse(), floor.cell_m());
  EXPECT_EQ(back.count(Floor::kFree), floor.count(Floor::kFree));
  for (int y = floor.known().low.y; y < floor.known().end.y; ++y) {
    for (int x = floor.known().low.x; x < floor.known().end.x; ++x)
      ASSERT_EQ(back.at(FloorCell{x, y}), floor.at(FloorCell{x, y}));
  }
}

TEST(MovedFloor, NarrowerCellsCoverTheSameFloor) {
  const FloorGrid floor = *furnished().floor;
  const FloorGrid fine = moved_floor(floor, {}, floor.cell_m() / 2);
  EXPECT_NEAR(fine.free_m2(), floor.free_m2(), 1e-9);
  const FloorGrid back = moved_floor(fine, {}, floor.cell_m());
  EXPECT_EQ(back.count(Floor::kOccupied), floor.count(Floor::kOccupied));
  EXPECT_EQ(back.count(Floor::kFree), floor.count(Floor::kFree));
}

TEST(MovedFloor, NoOccupiedCellIsLost) {
  FloorGrid floor;
  for (int i = 0; i < 200; ++i) floor.set({i, 3}, Floor::kOccupied);
  const Pose2 T{1, 2, 0.6};
  const FloorGrid moved = moved_floor(floor, T, floor.cell_m());
  for (int i = 0; i < 200; ++i) EXPECT_EQ(moved.at(Vec2(T * floor.centre({i, 3}))), Floor::kOccupied);
}

}  // namespace
}  // namespace aisle
