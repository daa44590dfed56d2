#pragma once

#include "aisle/maps/floor_grid.hpp"
#include "aisle/maps/wall_map.hpp"

namespace aisle {

/// A wall seen at a grazing angle hits only a cell here and there and yields no segment. So walls are
/// extended along their lines, both ways, as long as hits are found that no other wall explains. Remaining
/// rows of hit cells, along the map's axes or parallel to nearby walls and with free floor on one side,
/// become walls of their own, with one sighting and the sigma of a cell's width. New or moved ends are
/// kUnknown.
/// @param floor  of the same building, in `map`
void draw_grazing_walls(WallMap& map, const FloorGrid& floor);

}  // namespace aisle
