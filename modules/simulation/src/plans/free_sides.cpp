#include "aisle/simulation/plans/free_sides.hpp"

#include <algorithm>

#include "aisle/simulation/wall_grid.hpp"

namespace aisle {
namespace {

constexpr double kOpenSpace_m = 5;  ///< more free space than this does not count

double room_beside_m(const WallGrid& grid, const Segment2& wall, const Vec2& direction) {
  double room_m = 0;
  for (const double share : {0.25, 0.5, 0.75}) {
    const Vec2 beside = wall.start + share * (wall.end - wall.start) + kOffWall_m * direction;
    room_m += std::min(kOpenSpace_m, grid.cast(beside, direction));
  }
  return room_m;
}

}  // namespace

std::vector<Segment2> with_free_sides_left(const std::vector<Segment2>& walls) {
  const WallGrid grid(walls);
  std::vector<Segment2> turned;
  for (const Segment2& wall : walls) {
    const Vec2 left = left_normal(wall.end - wall.start).normalized();
    const bool is_right_freer = room_beside_m(grid, wall, -left) > room_beside_m(grid, wall, left);
    turned.push_back(is_right_freer ? wall.reversed() : wall);
  }
  return turned;
}

}  // namespace aisle
