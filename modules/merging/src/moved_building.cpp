#include "aisle/merging/moved_building.hpp"

#include <cmath>
#include <utility>

namespace aisle {
namespace {

constexpr double kStillOnAxis_rad = 1e-6;

WallMap moved_walls(const WallMap& walls, const Pose2& T_to_map) {
  const bool keeps_axes = std::abs(wrap_quarter_turn(T_to_map.theta)) < kStillOnAxis_rad;
  WallMap moved = walls;
  for (Wall& wall : moved.walls) {
    wall.segment = T_to_map * wall.segment;
    wall.is_orthogonal = wall.is_orthogonal && keeps_axes;
  }
  return moved;
}

std::vector<Landmark> moved_landmarks(std::vector<Landmark> landmarks, const Pose2& T_to_map) {
  const Mat2 turn = rotation(T_to_map.theta);
  for (Landmark& landmark : landmarks) {
    landmark.p_map = T_to_map * landmark.p_map;
    landmark.covariance = turn * landmark.covariance * turn.transpose();
    landmark.seen_from = turn * landmark.seen_from;
  }
  return landmarks;
}

Route moved_route(Route route, const Pose2& T_to_map) {
  std::vector<PathPiece> pieces = route.path.pieces();
  for (PathPiece& piece : pieces) piece.T_map_start = T_to_map * piece.T_map_start;
  route.path = Path(std::move(pieces));
  if (route.room) {
    for (RouteEdge& edge : route.room->edges) edge.p_map = T_to_map * edge.p_map;
  }
  return route;
}

CorridorGraph moved_corridors(CorridorGraph graph, const Pose2& T_to_map) {
  for (CorridorNode& node : graph.nodes) node.p_map = T_to_map * node.p_map;
  for (Corridor& corridor : graph.corridors) {
    for (Vec2& p : corridor.path) p = T_to_map * p;
  }
  return graph;
}

Zone moved_zone(Zone zone, const Pose2& T_to_map) {
  for (Vec2& corner : zone.outline) corner = T_to_map * corner;
  if (zone.kind == Zone::Kind::kOneWay) zone.direction_rad = wrap_angle(zone.direction_rad + T_to_map.theta);
  return zone;
}

/// The cells of the new grid that the floor may cover.
FloorBox covered_box(const FloorGrid& floor, const Pose2& T_to_map, const FloorGrid& moved) {
  const FloorBox& known = floor.known();
  FloorBox box;
  for (const int x : {known.low.x, known.end.x}) {
    for (const int y : {known.low.y, known.end.y})
      box.include(moved.cell_at(T_to_map * (floor.cell_m() * Vec2(x, y))));
  }
  return box.widened(1);
}

}  // namespace

FloorGrid moved_floor(const FloorGrid& floor, const Pose2& T_to_map, double cell_m) {
  FloorGrid moved(cell_m);
  if (floor.known().empty()) return moved;
  const Pose2 T_map_to = T_to_map.inverse();
  const FloorBox box = covered_box(floor, T_to_map, moved), &known = floor.known();
  for (int y = box.low.y; y < box.end.y; ++y) {
    for (int x = box.low.x; x < box.end.x; ++x) {
      const Floor seen = floor.at(Vec2(T_map_to * moved.centre({x, y})));
      if (seen != Floor::kUnknown) moved.set({x, y}, seen);
    }
  }
  for (int y = known.low.y; y < known.end.y; ++y) {
    for (int x = known.low.x; x < known.end.x; ++x) {
      if (floor.at(FloorCell{x, y}) != Floor::kOccupied) continue;
      moved.set(moved.cell_at(T_to_map * floor.centre({x, y})), Floor::kOccupied);
    }
  }
  return moved;
}

Building moved_building(const Building& building, const Pose2& T_to_map, std::optional<double> cell_m) {
  Building moved = building;
  moved.walls = moved_walls(building.walls, T_to_map);
  moved.landmarks.assign(moved_landmarks(building.landmarks.all(), T_to_map));
  for (WallDirection& direction : moved.wall_directions) {
    direction.p_map = T_to_map * direction.p_map;
    direction.direction_rad = wrap_quarter_turn(direction.direction_rad + T_to_map.theta);
  }
  for (Route& route : moved.routes) route = moved_route(std::move(route), T_to_map);
  moved.corridors = moved_corridors(building.corridors, T_to_map);
  for (MapPlace& place : moved.places) {
    place.T_map_place = T_to_map * place.T_map_place;
    if (!place.has_heading) place.T_map_place.theta = 0;
  }
  for (Barrier& barrier : moved.barriers) barrier.segment = T_to_map * barrier.segment;
  for (Zone& zone : moved.zones) zone = moved_zone(std::move(zone), T_to_map);
  if (building.floor)
    moved.floor = moved_floor(*building.floor, T_to_map, cell_m.value_or(building.floor->cell_m()));
  return moved;
}

}  // namespace aisle
