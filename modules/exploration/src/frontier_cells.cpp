#include "frontier_cells.hpp"

#include <algorithm>

namespace aisle {

void measure_frontier_cells(const FloorGrid& floor, Frontier& frontier) {
  Vec2 middle = Vec2::Zero();
  for (const FloorCell cell : frontier.cells) {
    frontier.box.include(cell);
    middle += floor.centre(cell) / static_cast<double>(frontier.cells.size());
  }
  const auto nearest =
      std::min_element(frontier.cells.begin(), frontier.cells.end(), [&](FloorCell a, FloorCell b) {
        return (floor.centre(a) - middle).squaredNorm() < (floor.centre(b) - middle).squaredNorm();
      });
  frontier.p_map = floor.centre(*nearest);
}

}  // namespace aisle
