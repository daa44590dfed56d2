#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "aisle/simulation/paths/clearance_grid.hpp"
#include "aisle/simulation/world.hpp"

namespace aisle {

/// Connected cells of a grid where a vehicle's centre can be.
struct DrivableArea {
  std::vector<bool> contains;  ///< for each cell
  std::size_t cells = 0;
  std::size_t shut_off_cells = 0;            ///< of the other areas on the free side of walls
  std::size_t largest_shut_off_cells = 0;    ///< of the largest of these
  std::optional<std::size_t> shut_off_cell;  ///< in the largest, far from walls
};

/// The area with that much clearance that contains the world's start; else the largest one on the free side
/// of walls, else the largest. No cells if there is none.
DrivableArea drivable_area(const World& world, const ClearanceGrid& grid, double clearance_min_m);

}  // namespace aisle
