#pragma once

#include "floor/side_view.hpp"
#include "route/region_growth.hpp"

namespace aisle {

/// Roughly where the floor is: the cells of the route region.
class FloorCells {
 public:
  void find(const Image& grey) { growth_.grow(grey); }

  /// Whether a point of a side view, which must be in the image, is in a cell of floor.
  bool contain(const SideView& view, const Vec2& point_px) const;
  int cell_px() const { return growth_.grid().cell_px; }

 private:
  RegionGrowth growth_{RegionParams{}};
};

}  // namespace aisle
