#pragma once

#include <vector>

#include "floor/side_view.hpp"
#include "route/cell_grid.hpp"

namespace aisle {

/// Roughly where the floor is: the cells of the route region.
class FloorCells {
 public:
  void find(const Image& grey);

  /// Whether a point of a side view, which must be in the picture, is in a cell of floor.
  bool contain(const SideView& view, const Vec2& point_px) const;
  int cell_px() const { return grid_.cell_px; }

 private:
  CellGrid grid_;
  std::vector<char> is_floor_;
};

}  // namespace aisle
