#pragma once

#include <vector>

#include "aisle/maps/wall_map.hpp"

namespace aisle {

/// Walls of the same evidence that touch on one line become one, and what lies within a wall of more
/// evidence, on its line, is left out: so walls that were cut do not stay cut for ever.
std::vector<Wall> joined_walls(std::vector<Wall> walls);

}  // namespace aisle
