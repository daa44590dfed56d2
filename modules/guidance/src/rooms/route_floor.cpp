#include "aisle/guidance/rooms/route_floor.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace aisle {
namespace {

constexpr double kFloorStep = 0.5;           // of a cell, between the points that are marked
constexpr double kSeenBeforeBumper_m = 0.4;  // nearer floor is below the first camera's view

/// Calls `visit` with numbers a step apart, from `first` to at most `last`.
template <typename Visit>
void step_through(double first, double last, double step, const Visit& visit) {
  const int steps = static_cast<int>(std::floor((last - first) / step));
  for (int i = 0; i <= steps; ++i) visit(first + i * step);
}

/// Frees the line of sight on which an edge was last seen.
void free_up_to(const RouteEdge& edge, const Path& path, const Footprint& footprint, FloorGrid& floor) {
  const Pose2 T_map_vehicle = path.at(edge.along_m).T_map_path;
  const Vec2 sight = edge.p_map - T_map_vehicle.position();
  const double ahead_m = sight.dot(unit(T_map_vehicle.theta));
  const double first_share = (footprint.front_m + kSeenBeforeBumper_m) / std::max(ahead_m, 1e-3);
  const double step_share = kFloorStep * floor.cell_m() / sight.norm();
  step_through(first_share, 1, step_share, [&](double share) {
    floor.set(floor.cell_at(T_map_vehicle.position() + share * sight), Floor::kFree);
  });
}

/// Frees the floor at the lower border of the first camera's view, out to the first edge on either side.
void free_before(const Footprint& footprint, const Pose2& T_map_vehicle, FloorGrid& floor) {
  constexpr double kLateral_m = 0.7;
  const double ahead_m = footprint.front_m + kSeenBeforeBumper_m;
  for (const double side : {-1.0, 1.0}) {
    const double step_m = kFloorStep * floor.cell_m();
    for (int i = 0; i * step_m < kLateral_m; ++i) {
      const FloorCell cell = floor.cell_at(T_map_vehicle * Vec2(ahead_m, side * i * step_m));
      if (floor.at(cell) == Floor::kOccupied) break;
      floor.set(cell, Floor::kFree);
    }
  }
}

/// Unknown cells with at least this many free neighbours.
std::vector<FloorCell> unknown_beside_free(const FloorGrid& floor, int free_min) {
  std::vector<FloorCell> cells;
  const FloorBox box = floor.known().widened(1);
  for (int y = box.low.y; y < box.end.y; ++y) {
    for (int x = box.low.x; x < box.end.x; ++x) {
      if (floor.at(FloorCell{x, y}) != Floor::kUnknown) continue;
      int free = 0;
      for (int i = 0; i < 9; ++i)
        free += floor.at(FloorCell{x + i % 3 - 1, y + i / 3 - 1}) == Floor::kFree ? 1 : 0;
      if (free >= free_min) cells.push_back({x, y});
    }
  }
  return cells;
}

/// Fills the gaps between lines of sight.
void close_gaps(FloorGrid& floor) {
  constexpr int kRounds = 3, kFreeNeighboursMin = 4;
  for (int round = 0; round < kRounds; ++round)
    for (const FloorCell& cell : unknown_beside_free(floor, kFreeNeighboursMin))
      floor.set(cell, Floor::kFree);
}

}  // namespace

void free_under(const Footprint& footprint, const Pose2& T_floor_vehicle, FloorGrid& floor) {
  const double step_m = kFloorStep * floor.cell_m();
  step_through(-footprint.rear_m, footprint.front_m, step_m, [&](double x) {
    step_through(-footprint.width_m / 2, footprint.width_m / 2, step_m,
                 [&](double y) { floor.set(floor.cell_at(T_floor_vehicle * Vec2(x, y)), Floor::kFree); });
  });
}

FloorGrid route_floor(const Path& path, std::span<const RouteEdge> edges, const Footprint& footprint,
                      const Vec2& p_map_place, double reach_m) {
  constexpr double kPathStep_m = 0.05;
  const auto is_near = [&](const Vec2& p_map) { return (p_map - p_map_place).norm() < reach_m; };
  FloorGrid floor;
  const auto put_edges = [&] {
    for (const RouteEdge& edge : edges) {
      if (is_near(edge.p_map)) floor.set(floor.cell_at(edge.p_map), Floor::kOccupied);
    }
  };
  put_edges();
  step_through(0, path.length_m(), kPathStep_m, [&](double along_m) {
    const Pose2 T_map_vehicle = path.at(along_m).T_map_path;
    if (!is_near(T_map_vehicle.position())) return;
    free_before(footprint, T_map_vehicle, floor);
    free_under(footprint, T_map_vehicle, floor);
  });
  for (const RouteEdge& edge : edges) {
    if (is_near(edge.p_map)) free_up_to(edge, path, footprint, floor);
  }
  close_gaps(floor);
  put_edges();
  return floor;
}

double share_with_edges_on_path(const Path& path, std::span<const RouteEdge> edges,
                                const Footprint& footprint) {
  constexpr double kPathSegment_m = 0.5;
  constexpr double kInset_m = 0.05;  // an obstacle just beside the path may seem this far inside it
  std::vector<char> has_edge(static_cast<std::size_t>(path.length_m() / kPathSegment_m) + 1, 0);
  for (const RouteEdge& edge : edges) {
    const PathPoint there = path.nearest(edge.p_map, edge.along_m, path.length_m());
    const double off_m = (edge.p_map - there.T_map_path.position()).norm();
    if (off_m < footprint.width_m / 2 - kInset_m)
      has_edge[static_cast<std::size_t>(there.along_m / kPathSegment_m)] = 1;
  }
  return static_cast<double>(std::count(has_edge.begin(), has_edge.end(), 1)) /
         static_cast<double>(has_edge.size());
}

std::vector<Vec2> limit_of_known(const FloorGrid& floor) {
  std::vector<Vec2> limit;
  for (const FloorCell& cell : unknown_beside_free(floor, 1)) limit.push_back(floor.centre(cell));
  return limit;
}

}  // namespace aisle
