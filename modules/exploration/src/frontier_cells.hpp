#pragma once

#include "aisle/exploration/frontiers.hpp"

namespace aisle {

/// Sets what follows of a frontier's frontier cells, which must not be empty: the box about it, and its cell
/// in the middle.
void measure_frontier_cells(const FloorGrid& floor, Frontier& frontier);

}  // namespace aisle
