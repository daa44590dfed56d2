#pragma once

#include <span>
#include <vector>

#include "aisle/geometry/sensed_segment.hpp"
#include "aisle/maps/wall_map.hpp"
#include "aisle/matching/wall_estimate.hpp"
#include "aisle/vehicle/laser_log.hpp"

namespace aisle {

/// A segment seen from a pose, on a wall.
struct WallSighting {
  Segment2 segment;   ///< in `map`
  int wall = 0;       ///< index of the wall
  double path_m = 0;  ///< the vehicle's path length at the sighting
};

/// A scan at its final pose.
struct PlacedScan {
  Pose2 T_map_laser;
  double path_m = 0;
  const LaserScan* scan = nullptr;
  LaserScanner laser;  ///< that took it, with the scan's beams
};

/// Draws the final map: walls on one line that touch become one; of two that lie on one another the one seen
/// more often is drawn there; parts that beams passed through or the vehicle drove through are cut out; walls
/// shorter or seen more rarely than the two limits are left out. Repeated sightings without moving on count
/// once. Scans and sightings must be in the order of the path. O(sightings + beams * walls near each beam).
WallMap draw_walls(const std::vector<WallEstimate>& walls, std::span<const WallSighting> sightings,
                   std::span<const PlacedScan> scans, double length_min_m, int sightings_min);

}  // namespace aisle
