#include "floor/floor_cells.hpp"

#include "route/region_growth.hpp"

namespace aisle {

void FloorCells::find(const Image& grey) {
  const RegionParams params;
  grid_ = cells_of(grey, params.columns);
  is_floor_ = region_cells(grid_, params);
}

bool FloorCells::contain(const SideView& view, const Vec2& point_px) const {
  const Vec2 at = (view.turned(point_px).array() + 0.5).matrix() / grid_.cell_px;
  return is_floor_[grid_.index(static_cast<int>(at.y()), static_cast<int>(at.x()))] != 0;
}

}  // namespace aisle
