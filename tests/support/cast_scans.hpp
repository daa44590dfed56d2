#pragma once
/// What a laser scanner among given walls measures, by casting rays.

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "aisle/geometry/segment2.hpp"
#include "aisle/vehicle/laser_log.hpp"

namespace aisle {

/// The walls along these corners, the last one joined to the first; counter-clockwise: seen from inside.
inline std::vector<Segment2> walls_around(const std::vector<Vec2>& corners) {
  std::vector<Segment2> walls;
  for (std::size_t i = 0; i < corners.size(); ++i)
    walls.push_back({corners[i], corners[(i + 1) % corners.size()]});
  return walls;
}

/// A room of 8 x 6 m with an oblique corner, an alcove, a cupboard and a pillar: it looks different from
/// everywhere.
inline std::vector<Segment2> uneven_room() {
  std::vector<Segment2> walls = walls_around(
      {{0, 0}, {6.5, 0}, {8, 1.5}, {8, 6}, {3, 6}, {3, 7}, {2, 7}, {2, 6}, {1.2, 6}, {1.2, 5}, {0, 5}});
  for (const Segment2& side : walls_around({{3.9, 2.9}, {3.9, 3.1}, {4.1, 3.1}, {4.1, 2.9}}))
    walls.push_back(side);
  return walls;
}

/// Two bare walls along x, 2 m apart, without ends in sight.
inline std::vector<Segment2> endless_corridor() {
  return {{{-1000, -1}, {1000, -1}}, {{1000, 1}, {-1000, 1}}};
}

/// The distance to the nearest wall; infinite if there is none.
inline double cast_ray_m(std::span<const Segment2> walls, const Vec2& from, const Vec2& ray) {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const Segment2& wall : walls) {
    const Vec2 along = wall.end - wall.start, to_wall = wall.start - from;
    const double parallel = cross(ray, along);
    if (std::abs(parallel) < 1e-9) continue;
    const double range_m = cross(to_wall, along) / parallel, share = cross(to_wall, ray) / parallel;
    if (range_m > 0 && share >= 0 && share <= 1) nearest_m = std::min(nearest_m, range_m);
  }
  return nearest_m;
}

/// One reading a beam; range_max_m: nothing seen.
inline std::vector<float> cast_scan(std::span<const Segment2> walls, const Pose2& T_map_laser,
                                    const LaserScanner& laser, std::size_t beams) {
  std::vector<float> ranges_m;
  for (std::size_t beam = 0; beam < beams; ++beam) {
    const Vec2 ray = unit(T_map_laser.theta + laser.beam_angle(beam));
    const double range_m = cast_ray_m(walls, T_map_laser.position(), ray);
    ranges_m.push_back(static_cast<float>(std::min(range_m, laser.range_max_m)));
  }
  return ranges_m;
}

/// A scanner that looks 135 degrees to both sides in steps of one.
inline constexpr LaserScanner kThreeQuarters{-135 * kDegree, 1 * kDegree, 30, {}};
inline constexpr std::size_t kThreeQuartersBeams = 271;

/// The points that this scanner sees, in its frame.
inline std::vector<Vec2> cast_points(std::span<const Segment2> walls, const Pose2& T_map_laser) {
  const std::vector<float> ranges_m = cast_scan(walls, T_map_laser, kThreeQuarters, kThreeQuartersBeams);
  std::vector<Vec2> points;
  for (std::size_t beam = 0; beam < ranges_m.size(); ++beam) {
    if (ranges_m[beam] < kThreeQuarters.range_max_m)
      points.push_back(ranges_m[beam] * unit(kThreeQuarters.beam_angle(beam)));
  }
  return points;
}

}  // namespace aisle
