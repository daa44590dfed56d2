#pragma once

#include <cstddef>
#include <vector>

#include "aisle/simulation/paths/clearance_grid.hpp"
#include "aisle/simulation/world.hpp"

namespace aisle {

/// Cells of a grid where a vehicle's centre can be and that hang together.
struct DrivableArea {
  std::vector<bool> contains;  ///< for each cell
  std::size_t cells = 0;
};

/// The area with that much clearance that the world's start is in; else the largest one on the free side of
/// walls, else the largest. No cells if there is no such area.
DrivableArea drivable_area(const World& world, const ClearanceGrid& grid, double clearance_min_m);

}  // namespace aisle
