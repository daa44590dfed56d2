#pragma once

#include "aisle/exploration/grid_world.hpp"
#include "aisle/simulation/world.hpp"

namespace aisle {

/// How the cells of a maze become corridors.
struct MazeBuildingParams {
  double corridor_width_m = 1.8;   ///< free, of every corridor
  double wall_thickness_m = 0.15;  ///< between neighbouring cells
};

/// The part of a maze that can be reached from its start, at full size: cell (0, 0) has its lower left corner
/// at the origin. A post that no wall reaches is left out. The start faces an open side; goals are the places
/// "goal", "goal 2" ...
World build_maze(const GridWorld& maze, const MazeBuildingParams& params);

}  // namespace aisle
