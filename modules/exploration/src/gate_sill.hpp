#pragma once

#include "aisle/exploration/gates.hpp"

namespace aisle {

/// Sets what follows of a gate's sill, which must not be empty: the box about it, and its cell in the middle.
void measure_sill(const FloorGrid& floor, Gate& gate);

}  // namespace aisle
