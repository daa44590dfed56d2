#pragma once
/// What is drawn into floor plans beside walls: doors as leaf and arc, letters.

#include <vector>

#include "aisle/simulation/plans/floor_plan.hpp"

namespace aisle {

/// A box of cells: column x to the right, row y up.
struct CellBox {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

struct PlanSymbols {
  std::vector<CellBox> doors;  ///< leaf and quarter arc
  std::vector<CellBox> marks;  ///< small free-standing strokes: letters, numbers
};

/// Frees the cells of every door that is drawn as a leaf along an axis of the plan and a quarter arc, in
/// strokes at most half as thick as the walls. Letters are listed and stay solid, as other thin strokes do.
/// In a plan whose walls are single lines nothing can be told apart by thickness: no symbols.
PlanSymbols open_drawn_doors(FloorPlan& plan);

}  // namespace aisle
