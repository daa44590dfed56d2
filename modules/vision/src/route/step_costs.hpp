#pragma once

#include <limits>
#include <vector>

#include "route/cell_grid.hpp"

namespace aisle {

using Cost = int;  ///< in look units

constexpr Cost kNoPath = std::numeric_limits<Cost>::max() / 4;  ///< two of them can be added

/// Cost of going from a cell to its neighbours: how different they look beyond a quiet step. Smaller steps
/// cost next to nothing. Keeps its memory from image to image.
class StepCosts {
 public:
  /// The usual step between neighbouring cells of a block on a rough surface; a steady change of looks, as
  /// from light, is no texture.
  Cost texture_of(const CellGrid& grid, const CellBlock& block, double colour_weight);

  void take(const CellGrid& grid, double colour_weight, Cost quiet_step);

  /// Lowers each cell's cost to that of the cheapest path from any other cell, that cell's own cost included.
  void spread(std::vector<Cost>& costs) const;

 private:
  bool spread_row(int row, int from_row, std::vector<Cost>& costs) const;

  int columns_ = 0;
  int rows_ = 0;
  std::vector<Cost> right_;  ///< to the right neighbour
  std::vector<Cost> down_;   ///< to the one below
  std::vector<Cost> distances_;
};

}  // namespace aisle
