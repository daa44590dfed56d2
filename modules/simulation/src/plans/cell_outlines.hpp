#pragma once

#include <vector>

#include "aisle/simulation/plans/floor_plan.hpp"

namespace aisle {

/// A corner of cells: (0, 0) is the lower left corner of cell (0, 0).
struct LatticePoint {
  int x = 0;
  int y = 0;
  bool operator==(const LatticePoint&) const = default;
};

/// The corners of a closed outline in their order, free on the left; the pieces between them alternate
/// between horizontal and vertical.
using Outline = std::vector<LatticePoint>;

/// Every border between free and solid cells. Solid cells that touch at a corner are connected, free ones are
/// not.
std::vector<Outline> cell_outlines(const FloorPlan& plan);

}  // namespace aisle
