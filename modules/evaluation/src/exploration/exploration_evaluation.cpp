#include "aisle/evaluation/exploration/exploration_evaluation.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "aisle/learning/corridors/corridor_tracing.hpp"
#include "aisle/simulation/cross_section.hpp"
#include "exploration/footprint_reach.hpp"

namespace aisle {
namespace {

constexpr double kLookEvery_m = 0.1;  ///< of the driven path
constexpr double kLookEvery_rad = 5 * kDegree;

double passable_radius_m(const VehicleDescription& vehicle) {
  return vehicle.footprint.width_m / 2 + kPassableMargin_m;
}

/// What the sensor would see from all poses that the vehicle's footprint can reach.
SensorView view_from_reachable_poses(std::span<const Segment2> standing, std::span<const Segment2> obstacles,
                                     const VehicleDescription& vehicle, const SensorField& sensor,
                                     const Pose2& T_world_start) {
  SensorView view(standing);
  for (const Pose2& T : poses_in_reach(obstacles, vehicle, T_world_start, kPassableMargin_m))
    view.look(T * sensor.T_vehicle_sensor, sensor.reach_m, sensor.width_rad);
  return view;
}

/// What the sensor saw along the driven path.
SensorView view_along_path(std::span<const Segment2> standing, const SensorField& sensor,
                           const std::vector<Pose2>& T_world_vehicle) {
  SensorView view(standing);
  Pose2 last{1e9, 0, 0};
  for (const Pose2& T : T_world_vehicle) {
    const Pose2 step = between(last, T);
    if (step.position().norm() < kLookEvery_m && std::abs(step.theta) < kLookEvery_rad) continue;
    last = T;
    view.look(T * sensor.T_vehicle_sensor, sensor.reach_m, sensor.width_rad);
  }
  return view;
}

bool is_known_nearby(const FloorGrid& floor, const Vec2& p_map) {
  const FloorCell cell = floor.cell_at(p_map);
  for (int y = cell.y - 1; y <= cell.y + 1; ++y) {
    for (int x = cell.x - 1; x <= cell.x + 1; ++x) {
      if (floor.at(FloorCell{x, y}) != Floor::kUnknown) return true;
    }
  }
  return false;
}

void add_coverage(ExplorationScore& figures, const SensorView& possible, const SensorView& seen,
                  const FloorGrid& floor, const Pose2& T_world_map) {
  const Pose2 T_map_world = T_world_map.inverse();
  std::size_t all = 0, covered = 0, mapped = 0;
  for (std::size_t cell = 0; cell < possible.size(); ++cell) {
    if (!possible.is_open_floor(cell)) continue;
    ++all;
    covered += seen.is_passed_nearby(cell) ? 1U : 0U;
    mapped += is_known_nearby(floor, T_map_world * possible.centre(cell)) ? 1U : 0U;
  }
  const double cells = std::max(1.0, static_cast<double>(all));
  figures.coverable_m2 = static_cast<double>(all) * possible.cell_m() * possible.cell_m();
  figures.covered_share = static_cast<double>(covered) / cells;
  figures.mapped_share = static_cast<double>(mapped) / cells;
}

/// A floor that is free within the bounding box of the obstacles, except for the obstacles.
FloorGrid floor_between(std::span<const Segment2> obstacles) {
  FloorGrid floor;
  FloorBox box{floor.cell_at(obstacles.front().start), floor.cell_at(obstacles.front().start)};
  for (const Segment2& s : obstacles) {
    box.include(floor.cell_at(s.start));
    box.include(floor.cell_at(s.end));
  }
  for (int y = box.low.y; y < box.end.y; ++y) {
    for (int x = box.low.x; x < box.end.x; ++x) floor.set({x, y}, Floor::kFree);
  }
  for (const Segment2& s : obstacles) {
    const auto steps = static_cast<int>(std::ceil(4 * s.length() / floor.cell_m())) + 1;
    for (int i = 0; i <= steps; ++i)
      floor.set(floor.cell_at(s.start + (s.end - s.start) * i / steps), Floor::kOccupied);
  }
  return floor;
}

}  // namespace

Pose2 map_in_world(const std::vector<Pose2>& T_map_vehicle, const std::vector<Pose2>& T_world_vehicle) {
  const std::size_t count = std::min(T_map_vehicle.size(), T_world_vehicle.size());
  if (count == 0) return {};
  Vec2 map_mean = Vec2::Zero(), world_mean = Vec2::Zero();
  for (std::size_t i = 0; i < count; ++i) {
    map_mean += T_map_vehicle[i].position() / static_cast<double>(count);
    world_mean += T_world_vehicle[i].position() / static_cast<double>(count);
  }
  double along = 0, across = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 a = T_map_vehicle[i].position() - map_mean, b = T_world_vehicle[i].position() - world_mean;
    along += a.dot(b);
    across += cross(a, b);
  }
  // Headings decide if the path is too short to determine the rotation.
  for (std::size_t i = 0; i < count; ++i) {
    const double turn_rad = T_world_vehicle[i].theta - T_map_vehicle[i].theta;
    along += std::cos(turn_rad);
    across += std::sin(turn_rad);
  }
  const double turn_rad = std::atan2(across, along);
  const Vec2 shift = world_mean - rotate(turn_rad, map_mean);
  return {shift.x(), shift.y(), turn_rad};
}

CorridorGraph true_corridors(const World& world, const VehicleDescription& vehicle,
                             const Vec2& p_world_start) {
  const std::vector<Segment2> obstacles = obstacles_below(world, vehicle.footprint.height_m);
  if (obstacles.empty()) return {};
  return trace_corridors(floor_between(obstacles), p_world_start,
                         {.clearance_min_m = passable_radius_m(vehicle)});
}

ExplorationScore evaluate_exploration(const World& world, const VehicleDescription& vehicle,
                                      const SensorField& sensor, const DrivenExploration& driven) {
  const std::vector<Segment2> standing = cross_section(world, sensor.height_m);
  const std::vector<Segment2> obstacles = obstacles_below(world, vehicle.footprint.height_m);
  const Pose2& T_world_start = driven.T_world_vehicle.front();
  ExplorationScore figures;
  const Pose2 home_error = between(T_world_start, driven.T_world_vehicle.back());
  figures.home_error_m = home_error.position().norm();
  figures.home_error_rad = std::abs(home_error.theta);
  if (standing.empty()) return figures;

  const SensorView possible = view_from_reachable_poses(standing, obstacles, vehicle, sensor, T_world_start);
  const SensorView seen = view_along_path(standing, sensor, driven.T_world_vehicle);
  add_coverage(figures, possible, seen, driven.floor, driven.T_world_map);
  figures.walls = wall_errors(driven.walls, driven.T_world_map, standing,
                              [&](const Vec2& p_world) { return possible.is_hit(p_world); });
  figures.graph_bound_m = 2 * true_corridors(world, vehicle, T_world_start.position()).length_m();
  return figures;
}

}  // namespace aisle
