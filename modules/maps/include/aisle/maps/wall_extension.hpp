#pragma once

#include "aisle/maps/floor_grid.hpp"
#include "aisle/maps/wall_map.hpp"

namespace aisle {

/// A wall that is seen at a grazing angle strikes a cell of the floor here and there, and makes no segment.
/// So walls are led on along their lines, in both directions, as far as something was struck there that no
/// wall explains. Ends that are moved are kUnknown.
/// @param floor  the same building's, in `map`
void extend_walls(WallMap& map, const FloorGrid& floor);

}  // namespace aisle
