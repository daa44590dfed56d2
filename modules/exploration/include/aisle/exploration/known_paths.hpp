#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "aisle/exploration/grid_world.hpp"

namespace aisle {

/// Shortest paths through the visited part of a world. Keeps its memory from search to search.
class KnownPaths {
 public:
  /// The visited cell nearest to `from` for which `is_goal` is true.
  /// @return nullopt if there is none, or none among the first `max_cells` that were searched
  template <class IsGoal>
  std::optional<std::size_t> search(const LearnedGrid& map, std::size_t from, IsGoal is_goal,
                                    std::size_t max_cells = SIZE_MAX);

  /// Moves from the latest search's `from` to a cell that it reached.
  std::uint32_t distance(std::size_t cell) const { return distances_[cell]; }

  /// The moves from the latest search's `from` to `goal`, which it must have found, in reverse order: the
  /// first move is last.
  void take_path(const LearnedGrid& map, std::size_t goal, std::vector<Side>& path) const;

 private:
  void begin(std::size_t cells, std::size_t from);
  bool is_new(std::size_t cell) const { return stamps_[cell] != stamp_; }

  std::vector<std::uint32_t> stamps_;  ///< the last search that reached the cell
  std::vector<Side> entered_by_;       ///< the move into the cell
  std::vector<std::uint32_t> distances_;
  std::vector<std::uint32_t> queue_;
  std::uint32_t stamp_ = 0;
  std::size_t from_ = 0;
};

template <class IsGoal>
std::optional<std::size_t> KnownPaths::search(const LearnedGrid& map, std::size_t from, IsGoal is_goal,
                                              std::size_t max_cells) {
  begin(map.size(), from);
  if (is_goal(from)) return from;
  for (std::size_t next = 0; next < queue_.size() && next < max_cells; ++next) {
    const std::size_t cell = queue_[next];
    for (const Side side : kAllSides) {
      if (!contains(map.open(cell), side)) continue;
      const std::size_t beyond = map.neighbour(cell, side);
      if (!is_new(beyond) || !map.visited(beyond)) continue;
      stamps_[beyond] = stamp_;
      entered_by_[beyond] = side;
      distances_[beyond] = distances_[cell] + 1;
      if (is_goal(beyond)) return beyond;
      queue_.push_back(static_cast<std::uint32_t>(beyond));
    }
  }
  return std::nullopt;
}

}  // namespace aisle
