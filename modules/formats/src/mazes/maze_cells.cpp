#include "mazes/maze_cells.hpp"

#include <fmt/format.h>

namespace aisle {
namespace {

constexpr const char* kSideNames[] = {"west", "east", "south", "north"};

}  // namespace

void MazeCells::check(Cell cell, const std::function<void(const std::string&)>& problem) const {
  for (const Side side : kAllSides) {
    const bool wall = contains(walls_[world_.index(cell)], side);
    const Cell beyond = neighbour(cell, side);
    const char* name = kSideNames[static_cast<unsigned>(side)];
    if (!world_.contains(beyond)) {
      if (!wall)
        problem(fmt::format("cell ({}, {}): the outer wall in the {} is missing", cell.x, cell.y, name));
    } else if (wall && !contains(walls_[world_.index(beyond)], opposite(side))) {
      problem(fmt::format("cell ({}, {}) has a wall in the {} that cell ({}, {}) has not", cell.x, cell.y,
                          name, beyond.x, beyond.y));
    }
  }
}

GridWorld MazeCells::world() const {
  GridWorld world = world_;
  for (int y = 0; y < world.height(); ++y) {
    for (int x = 0; x < world.width(); ++x) {
      for (const Side side : {Side::kRight, Side::kTop}) {
        if (world.contains(neighbour({x, y}, side))) {
          world.set_open({x, y}, side, !contains(walls_[world.index({x, y})], side));
        }
      }
    }
  }
  return world;
}

}  // namespace aisle
