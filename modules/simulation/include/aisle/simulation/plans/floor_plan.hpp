#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// A floor seen from above, in square cells that are solid or free. Column x to the right, row y UP; what
/// lies outside the plan is solid.
struct FloorPlan {
  int width = 0;
  int height = 0;
  double cell_m = 0.05;
  Pose2 T_world_plan;               ///< of the lower left corner of cell (0, 0), x along the rows
  std::vector<std::uint8_t> solid;  ///< row by row from the bottom one; 1 solid, 0 free

  FloorPlan() = default;
  FloorPlan(int columns, int rows, std::uint8_t fill)
      : width(columns),
        height(rows),
        solid(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), fill) {}

  bool contains(int x, int y) const { return x >= 0 && x < width && y >= 0 && y < height; }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
  bool is_solid(int x, int y) const { return !contains(x, y) || solid[index(x, y)] != 0; }
  Vec2 centre(int x, int y) const { return T_world_plan * Vec2((x + 0.5) * cell_m, (y + 0.5) * cell_m); }
};

}  // namespace aisle
