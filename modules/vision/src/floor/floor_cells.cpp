#include "floor/floor_cells.hpp"

namespace aisle {

bool FloorCells::contain(const SideView& view, const Vec2& point_px) const {
  const CellGrid& grid = growth_.grid();
  const Vec2 at = (view.turned(point_px).array() + 0.5).matrix() / grid.cell_px;
  return growth_.region()[grid.index(static_cast<int>(at.y()), static_cast<int>(at.x()))] != 0;
}

}  // namespace aisle
