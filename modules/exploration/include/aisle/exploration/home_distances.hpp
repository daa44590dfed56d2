#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "aisle/exploration/grid_world.hpp"

namespace aisle {

/// How far each visited cell is from the start by known paths, kept up to date while cells are added. In
/// large worlds a new short cut is not followed to all that it brings nearer: distances may then be too long.
class HomeDistances {
 public:
  HomeDistances(std::size_t cells, std::size_t start);

  /// The cell was visited just now and is in the map.
  void add(const LearnedGrid& map, std::size_t cell);
  std::uint32_t operator[](std::size_t cell) const { return distances_[cell]; }

 private:
  std::vector<std::uint32_t> distances_;
  std::vector<std::uint32_t> changed_;
};

}  // namespace aisle
