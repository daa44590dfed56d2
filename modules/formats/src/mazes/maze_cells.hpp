#pragma once

#include <functional>
#include <string>
#include <vector>

#include "aisle/exploration/grid_world.hpp"

namespace aisle {

/// A maze given cell by cell, so that two cells may contradict each other about their common edge.
class MazeCells {
 public:
  MazeCells(int width, int height) : world_(width, height), walls_(world_.size(), kNoSides) {}

  Sides& walls(Cell cell) { return walls_[world_.index(cell)]; }

  /// Reports what is wrong with a cell's walls: a missing outer wall, or a wall that the neighbouring cell
  /// lacks.
  void check(Cell cell, const std::function<void(const std::string&)>& problem) const;

  /// Only valid if no cell has a problem.
  GridWorld world() const;

 private:
  GridWorld world_;
  std::vector<Sides> walls_;
};

}  // namespace aisle
