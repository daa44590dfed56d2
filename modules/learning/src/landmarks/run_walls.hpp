#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "aisle/learning/walls/wall_heading.hpp"
#include "aisle/maps/wall_direction.hpp"

namespace aisle {

/// The heading of the vehicle in a cycle against the walls around.
struct WallObservation {
  std::size_t cycle = 0;
  int walls = 0;  ///< whose direction is one unknown, from 0 on; never less than in the cycle before
  HeadingMeasurement against_walls;
};

/// Which way walls run along a run, segment by segment; those where hardly anything tells it are left out.
/// @param seen  in the order of the cycles
std::vector<WallDirection> wall_directions(std::span<const WallObservation> seen,
                                           std::span<const Pose2> T_map_vehicle);

}  // namespace aisle
