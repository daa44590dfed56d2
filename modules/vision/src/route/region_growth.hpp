#pragma once

#include <vector>

#include "aisle/vision/route/route_region.hpp"
#include "route/cell_grid.hpp"
#include "route/step_costs.hpp"

namespace aisle {

/// The cells of the route region, see RouteRegionFinder. Keeps its memory from image to image.
class RegionGrowth {
 public:
  explicit RegionGrowth(const RegionParams& params) : params_(params) {}

  void grow(const Image& image);

  /// Of the latest image.
  const CellGrid& grid() const { return grid_; }
  /// For each of its cells whether it is of the region.
  const std::vector<char>& region() const { return is_region_; }

 private:
  void expect();
  void find_patch();
  CellLook patch_look();
  Cost quiet_step();
  double lateral(int column) const;
  double expected_floor(int row, int column) const;
  double expected_rest(int row, int column) const;
  void find_unmatched();
  void connect();
  void reach(std::size_t cell);

  RegionParams params_;
  CellGrid grid_;
  CellBlock patch_;
  StepCosts steps_;
  std::vector<Cost> expected_floor_, expected_rest_;  ///< before any step, for all images of one size
  std::vector<Cost> floor_, rest_;                    ///< what it costs to take a cell for either
  std::vector<char> is_unmatched_, is_floor_, is_region_;
  std::vector<std::size_t> open_;
  std::vector<int> looks_;
};

}  // namespace aisle
