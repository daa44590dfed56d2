#include "frontier_cells.hpp"

#include <algorithm>

namespace aisle {

void measure_frontier_cells(const FloorGrid& floor, Frontier& frontier) {
  Vec2 middle = Vec2::Zero();
  for (const FloorCell cell : frontier.frontier_cells) {
    frontier.box.include(cell);
    middle += floor.centre(cell) / static_cast<double>(frontier.frontier_cells.size());
  }
  const auto nearest = std::min_element(
      frontier.frontier_cells.begin(), frontier.frontier_cells.end(), [&](FloorCell a, FloorCell b) {
        return (floor.centre(a) - middle).squaredNorm() < (floor.centre(b) - middle).squaredNorm();
      });
  frontier.p_map = floor.centre(*nearest);
}

}  // namespace aisle
