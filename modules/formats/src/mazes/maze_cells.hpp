#pragma once

#include <functional>
#include <string>
#include <vector>

#include "aisle/exploration/grid_world.hpp"

namespace aisle {

/// A maze given cell by cell, so that the two cells of an edge may contradict each other.
class MazeCells {
 public:
  MazeCells(int width, int height) : world_(width, height), walls_(world_.size(), kNoSides) {}

  Sides& walls(Cell cell) { return walls_[world_.index(cell)]; }

  /// Says what is wrong with a cell's walls: an outer one missing, or one that the cell behind it does not
  /// have.
  void check(Cell cell, const std::function<void(const std::string&)>& problem) const;

  /// Where all cells are right.
  GridWorld world() const;

 private:
  GridWorld world_;
  std::vector<Sides> walls_;
};

}  // namespace aisle
