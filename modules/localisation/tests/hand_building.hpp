#pragma once
/// Buildings that can be checked by hand, and what a scanner sees in them.

#include <cmath>
#include <limits>
#include <vector>

#include "aisle/core/random.hpp"
#include "aisle/maps/building.hpp"

namespace aisle::hand {

/// Walls along a closed polygon, free on the left.
inline void add_outline(const std::vector<Vec2>& corners, Building& building) {
  for (std::size_t i = 0; i < corners.size(); ++i)
    building.walls.walls.push_back({.segment = {corners[i], corners[(i + 1) % corners.size()]}});
}

/// A square obstacle, by its lower left corner.
inline void add_box(const Vec2& p_low, double side_m, Building& building) {
  const double x = p_low.x(), y = p_low.y();
  add_outline({{x, y}, {x, y + side_m}, {x + side_m, y + side_m}, {x + side_m, y}}, building);
}

/// An L-shaped room of 12 x 8 m with a pillar: no two places in it look alike.
inline Building l_room() {
  Building building;
  add_outline({{0, 0}, {12, 0}, {12, 5}, {5, 5}, {5, 8}, {0, 8}}, building);
  add_outline({{3, 2}, {3, 2.6}, {3.8, 2.6}, {3.8, 2}}, building);
  return building;
}

/// A bare rectangular room: every view fits twice, turned by half a circle.
inline Building bare_room() {
  Building building;
  add_outline({{0, 0}, {10, 0}, {10, 6}, {0, 6}}, building);
  return building;
}

/// A corridor of 30 m with alcoves on one side, all alike but for one at x = 21 m that is missing.
inline Building corridor_with_alcoves() {
  std::vector<Vec2> corners{{0, 0}, {30, 0}, {30, 2}};
  for (double x = 27; x >= 2; x -= 3) {
    if (std::abs(x - 21) < 1) continue;
    corners.insert(corners.end(), {{x + 1, 2}, {x + 1, 3}, {x, 3}, {x, 2}});
  }
  corners.push_back({0, 2});
  Building building;
  add_outline(corners, building);
  return building;
}

/// Distance along a ray to the nearest wall [m]; infinity: there is none.
inline double cast(const Building& building, const Vec2& p_map, double heading_rad) {
  const Vec2 direction = unit(heading_rad);
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const Wall& wall : building.walls.walls) {
    const Vec2 along = wall.segment.end - wall.segment.start, to_wall = wall.segment.start - p_map;
    const double area = cross(direction, along);
    if (std::abs(area) < 1e-12) continue;
    const double distance_m = cross(to_wall, along) / area, share = cross(to_wall, direction) / area;
    if (distance_m > 0 && share >= 0 && share <= 1) nearest_m = std::min(nearest_m, distance_m);
  }
  return nearest_m;
}

/// The hits of a scanner at the vehicle's origin, in its frame: one beam a degree, with noise.
inline std::vector<Vec2> scan(const Building& building, const Pose2& T_map_vehicle, double reach_m,
                              Random& random, double noise_m = 0.01) {
  std::vector<Vec2> hits;
  for (int beam = 0; beam < 360; ++beam) {
    const double angle_rad = beam * kDegree;
    const double range_m = cast(building, T_map_vehicle.position(), T_map_vehicle.theta + angle_rad);
    if (range_m < reach_m) hits.push_back((range_m + random.normal(noise_m)) * unit(angle_rad));
  }
  return hits;
}

}  // namespace aisle::hand
