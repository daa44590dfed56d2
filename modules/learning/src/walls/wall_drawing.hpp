#pragma once

#include <span>
#include <vector>

#include "aisle/geometry/sensed_segment.hpp"
#include "aisle/maps/wall_map.hpp"
#include "aisle/matching/wall_estimate.hpp"
#include "aisle/vehicle/laser_log.hpp"

namespace aisle {

/// A segment that was seen from a pose and belongs to a wall.
struct WallSighting {
  Segment2 segment;   ///< in `map`
  int wall = 0;       ///< index of the wall
  double path_m = 0;  ///< the vehicle's path up to the sighting
};

/// A scan at its final pose.
struct PlacedScan {
  Pose2 T_map_laser;
  double path_m = 0;
  const LaserScan* scan = nullptr;
};

/// Draws the final map: walls that lie on one line and touch become one, what beams passed through or the
/// vehicle drove through is cut out, and what is shorter or was seen more rarely than the two limits is left
/// out. What is seen again without having moved on is seen once. Scans and sightings come in the order of the
/// path. O(sightings + beams * walls near each beam).
WallMap draw_walls(const std::vector<WallEstimate>& walls, std::span<const WallSighting> sightings,
                   std::span<const PlacedScan> scans, const LaserScanner& laser, double length_min_m,
                   int sightings_min);

}  // namespace aisle
