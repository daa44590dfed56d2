#include "aisle/commands/known_building.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "aisle/commands/plan_reading.hpp"
#include "aisle/formats/buildings/building_json.hpp"
#include "aisle/formats/images/cell_map.hpp"
#include "aisle/simulation/plans/plan_tracing.hpp"

namespace aisle {
namespace {

constexpr double kBehind_cells = 1.5;  // occupied within this behind a border: it is a wall
constexpr double kLeastWall_cells = 2;
constexpr double kSigma_cells = 0.25;  // of a wall's position
constexpr int kSightings = 10;         // as of a wall that was seen often
constexpr double kOnAxis_rad = 1e-6;

bool has_wall_behind(const PlanReading& map, const Vec2& p_map, const Vec2& normal) {
  const double cell_m = map.plan.cell_m;
  for (const double cells : {0.5, 1.0, kBehind_cells}) {
    if (floor_at(map, p_map - cells * cell_m * normal) == Floor::kOccupied) return true;
  }
  return false;
}

Wall wall_of(const Segment2& segment, double cell_m) {
  const double off_axis_rad = std::remainder(segment.heading(), kPi / 2);
  return {.segment = segment,
          .is_orthogonal = std::abs(off_axis_rad) < kOnAxis_rad,
          .sightings = kSightings,
          .sigma_m = kSigma_cells * cell_m};
}

/// The parts of a border that have occupied cells behind them.
void add_walls(const PlanReading& map, const Segment2& border, std::vector<Wall>& walls) {
  const double length_m = border.length(), cell_m = map.plan.cell_m;
  if (!(length_m > 0)) return;
  const Vec2 along = (border.end - border.start) / length_m, normal = left_normal(along);
  const int steps = std::max(1, static_cast<int>(std::lround(length_m / cell_m)));
  std::optional<double> begun_m;
  for (int i = 0; i <= steps; ++i) {
    const double at_m = length_m * i / steps, middle_m = length_m * (i + 0.5) / steps;
    const bool is_wall = i < steps && has_wall_behind(map, border.start + middle_m * along, normal);
    if (is_wall && !begun_m) begun_m = at_m;
    if (is_wall || !begun_m) continue;
    if (at_m - *begun_m >= kLeastWall_cells * cell_m || steps < kLeastWall_cells)
      walls.push_back(wall_of({border.start + *begun_m * along, border.start + at_m * along}, cell_m));
    begun_m.reset();
  }
}

FloorGrid floor_of(const PlanReading& map) {
  const FloorPlan& plan = map.plan;
  FloorGrid floor(plan.cell_m);
  FloorBox box;
  for (const int x : {0, plan.width}) {
    for (const int y : {0, plan.height})
      box.include(floor.cell_at(plan.T_world_plan * Vec2(x * plan.cell_m, y * plan.cell_m)));
  }
  for (int y = box.low.y; y < box.end.y; ++y) {
    for (int x = box.low.x; x < box.end.x; ++x) {
      const Floor seen = floor_at(map, floor.centre({x, y}));
      if (seen != Floor::kUnknown) floor.set({x, y}, seen);
    }
  }
  return floor;
}

}  // namespace

Floor floor_at(const PlanReading& map, const Vec2& p_map) {
  const FloorPlan& plan = map.plan;
  const Vec2 p = (plan.T_world_plan.inverse() * p_map) / plan.cell_m;
  const int x = static_cast<int>(std::floor(p.x())), y = static_cast<int>(std::floor(p.y()));
  if (!plan.contains(x, y)) return Floor::kUnknown;
  if (!plan.is_solid(x, y)) return Floor::kFree;
  const bool is_unseen = !map.unseen.empty() && map.unseen[plan.index(x, y)] != 0;
  return is_unseen ? Floor::kUnknown : Floor::kOccupied;
}

Result<Building> building_of_map(const PlanReading& map, std::string name, Progress& progress) {
  const auto borders = trace_plan(map.plan, {}, progress);
  if (!borders) return Problem{{name}, "has more than a million corners: no map of a building"};
  Building building;
  building.name = std::move(name);
  for (const Segment2& border : *borders) add_walls(map, border, building.walls.walls);
  building.has_dominant_direction = building.walls.orthogonal_share() > 0;
  building.floor = floor_of(map);
  return building;
}

Result<Building> read_map_building(const std::filesystem::path& path, Console& console) {
  const auto map = read_cell_map(path);
  if (!map) return map.problems();
  warn_of(map->warnings, console);
  auto building = building_of_map(*map, path.stem().string(), console.progress);
  if (!building) return at_file(building.problems(), path.string());
  if (building->walls.walls.empty() && building->floor->count(Floor::kOccupied) == 0)
    return Problem{{path.string()}, "shows no walls"};
  return building;
}

Result<Building> read_known_building(const std::filesystem::path& file, Console& console) {
  if (!is_plan(file) || file.extension() == ".json") return read_building(file);
  return read_map_building(file, console);
}

}  // namespace aisle
