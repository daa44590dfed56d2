#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "aisle/core/progress.hpp"
#include "aisle/simulation/paths/clearance_grid.hpp"
#include "paths/drivable_area.hpp"

namespace aisle {

/// Cheapest paths from one cell to every other cell of an area, and a choice of them that covers the area.
class PathTree {
 public:
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

  /// Paths cost their length, more where there is little clearance.
  PathTree(const ClearanceGrid& grid, const DrivableArea& area, std::size_t root, Progress& progress);

  /// Chooses paths until every cell of the area is within `reach_m`, measured over the floor, of one.
  void choose_paths(double reach_m, Progress& progress);

  std::size_t root() const { return root_; }
  /// The cells that chosen paths lead to next from this one.
  std::vector<std::size_t> branches(std::size_t cell) const;

 private:
  struct Step {
    std::size_t cell = 0;
    double length_m = 0;
  };

  template <class Use>
  void for_steps_from(std::size_t cell, Use use) const;
  void find_cheapest_paths(Progress& progress);
  void choose_path_towards(std::size_t target, double reach_m);
  void cover_around(const std::vector<std::size_t>& cells, double reach_m);

  const ClearanceGrid& grid_;
  const DrivableArea& area_;
  std::size_t root_;
  std::vector<std::size_t> parent_;
  std::vector<std::size_t> by_cost_;  ///< cells, the cheapest first
  std::vector<bool> chosen_;
  std::vector<float> nearest_path_m_;
};

}  // namespace aisle
