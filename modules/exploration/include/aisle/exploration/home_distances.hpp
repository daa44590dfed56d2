#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "aisle/exploration/grid_world.hpp"

namespace aisle {

/// How many moves each visited cell is from the start by known paths, updated as cells are added. In large
/// worlds a new shortcut is not propagated to everything that it brings nearer, so distances may be too long.
class HomeDistances {
 public:
  HomeDistances(std::size_t cells, std::size_t start);

  /// Call this once the cell was just visited and is in the map.
  void add(const LearnedGrid& map, std::size_t cell);
  std::uint32_t operator[](std::size_t cell) const { return distances_[cell]; }

 private:
  std::vector<std::uint32_t> distances_;
  std::vector<std::uint32_t> changed_;
};

}  // namespace aisle
