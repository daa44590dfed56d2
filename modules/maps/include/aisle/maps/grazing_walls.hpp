#pragma once

#include "aisle/maps/floor_grid.hpp"
#include "aisle/maps/wall_map.hpp"

namespace aisle {

/// A wall that is seen at a grazing angle strikes a cell of the floor here and there, and makes no segment.
/// So walls are led on along their lines, in both directions, as far as something was hit there that no
/// wall explains. Rows of hit cells that are left then, along the map's axes or the walls nearby and with
/// free floor on one side, are walls of their own, of one sighting and as sure as a cell is wide. Ends that
/// are made or moved are kUnknown.
/// @param floor  the same building's, in `map`
void draw_grazing_walls(WallMap& map, const FloorGrid& floor);

}  // namespace aisle
