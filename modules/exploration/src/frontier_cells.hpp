#pragma once

#include "aisle/exploration/frontiers.hpp"

namespace aisle {

/// Sets what follows from a frontier's cells, which must not be empty: their bounding box and the middle
/// cell.
void measure_frontier_cells(const FloorGrid& floor, Frontier& frontier);

}  // namespace aisle
