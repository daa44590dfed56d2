#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "aisle/learning/walls/wall_heading.hpp"
#include "aisle/maps/wall_direction.hpp"

namespace aisle {

/// The vehicle's heading in a cycle relative to the walls around.
struct WallObservation {
  std::size_t cycle = 0;
  int walls = 0;  ///< index of the walls' common direction, from 0 on; never less than in the previous cycle
  HeadingMeasurement against_walls;
};

/// The walls' directions along a run, segment by segment, without those that are hardly observed.
/// @param seen  in the order of the cycles
std::vector<WallDirection> wall_directions(std::span<const WallObservation> seen,
                                           std::span<const Pose2> T_map_vehicle);

}  // namespace aisle
