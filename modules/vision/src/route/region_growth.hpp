#pragma once

#include <vector>

#include "aisle/vision/route/route_region.hpp"
#include "route/cell_grid.hpp"

namespace aisle {

/// For each cell whether it is of the route region, see find_route_region(): one connected region.
std::vector<char> region_cells(const CellGrid& grid, const RegionParams& params);

}  // namespace aisle
