#pragma once

#include "aisle/maps/floor_grid.hpp"

namespace aisle {

/// Whether a cell is occupied, or one at most so many columns and rows away. O(cells^2).
bool is_occupied_near(const FloorGrid& floor, FloorCell cell, int cells);

}  // namespace aisle
