#include "exploration/exploration_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "aisle/geometry/box2.hpp"
#include "aisle/simulation/cross_section.hpp"
#include "aisle/simulation/paths/clearance_grid.hpp"
#include "aisle/simulation/vehicle/simulated_vehicle.hpp"
#include "aisle/simulation/wall_grid.hpp"

namespace aisle {
namespace {

constexpr double kOpeningCell_m = 0.05;
constexpr double kNearStart_m = 0.5;
constexpr int kRays = 72;
constexpr double kOutsideShare = 0.4;  ///< share of rays without a hit from which on a place is outside

/// Clearance as far out of the rectangle as the vehicle is wide: a grid is closed at its edge.
ClearanceGrid clearance_around(std::vector<Segment2> obstacles, const Box2& box, double width_m) {
  const Vec2 beyond = Vec2::Constant(width_m + 0.5), low = box.min() - beyond, high = box.max() + beyond;
  obstacles.push_back({low, low});
  obstacles.push_back({high, high});
  return ClearanceGrid(obstacles, kOpeningCell_m);
}

/// The shortest path of cells from a place out of the rectangle; empty if there is none.
std::vector<Vec2> path_out(const ClearanceGrid& grid, const Box2& box, const Vec2& start,
                           double clearance_m) {
  constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  std::vector<std::size_t> came_from(grid.size(), kNone), open;
  for (std::size_t cell = 0; cell < grid.size(); ++cell) {
    if ((grid.centre(cell) - start).norm() > kNearStart_m || grid.clearance_m(cell) < clearance_m) continue;
    came_from[cell] = cell;
    open.push_back(cell);
  }
  const auto columns = static_cast<std::size_t>(grid.columns());
  for (std::size_t next = 0; next < open.size(); ++next) {
    const std::size_t cell = open[next];
    if (!box.contains(grid.centre(cell))) {
      std::vector<Vec2> path = {grid.centre(cell)};
      for (std::size_t at = cell; came_from[at] != at; at = came_from[at])
        path.push_back(grid.centre(came_from[at]));
      std::reverse(path.begin(), path.end());
      return path;
    }
    for (const std::size_t beside : {cell + 1, cell - 1, cell + columns, cell - columns}) {
      if (came_from[beside] != kNone || grid.clearance_m(beside) < clearance_m) continue;
      came_from[beside] = cell;
      open.push_back(beside);
    }
  }
  return {};
}

bool is_outside(const WallGrid& walls, const Vec2& p) {
  int unbounded = 0;
  for (int i = 0; i < kRays; ++i) unbounded += std::isinf(walls.cast(p, unit(2 * kPi * i / kRays))) ? 1 : 0;
  return unbounded >= kOutsideShare * kRays;
}

}  // namespace

std::optional<Vec2> opening_of(const World& world, const VehicleDescription& vehicle,
                               const Vec2& p_world_start) {
  const std::vector<Segment2> obstacles = obstacles_below(world, vehicle.footprint.height_m);
  if (obstacles.empty()) return p_world_start;
  const Box2 box = box_around(obstacles);
  if (!box.contains(p_world_start)) return p_world_start;
  const double width_m = vehicle.footprint.width_m;
  const ClearanceGrid grid = clearance_around(obstacles, box, width_m);
  const std::vector<Vec2> path = path_out(grid, box, p_world_start, width_m / 2);
  if (path.empty()) return std::nullopt;
  const WallGrid walls(obstacles);
  const auto first =
      std::find_if(path.begin(), path.end(), [&](const Vec2& p) { return is_outside(walls, p); });
  return first == path.end() ? path.back() : *first;
}

Problems check_explorable(const World& world, const std::string& world_file,
                          const VehicleDescription& vehicle, const Pose2& T_world_start) {
  const Vec2 p = T_world_start.position();
  if (!fits(world, vehicle.footprint, T_world_start)) {
    return {
        {{world_file, 0, "start"},
         fmt::format("the vehicle does not fit at {:.2f}, {:.2f}: an obstacle is in the way", p.x(), p.y())}};
  }
  if (const auto opening = opening_of(world, vehicle, p)) {
    return {{{world_file, 0, "walls"},
             fmt::format(
                 "the floor leads out of the building near {:.1f}, {:.1f}; a world to explore is closed, or "
                 "its openings are narrower than the vehicle",
                 opening->x(), opening->y())}};
  }
  return {};
}

}  // namespace aisle
