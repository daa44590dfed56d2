#pragma once

#include <cstdint>
#include <vector>

#include "floor/level_view.hpp"

namespace aisle {

/// Where the floor ends in one column of a level view.
struct BoundaryPoint {
  double column = 0, row = 0;  ///< sub-pixel
  double contrast = 0;         ///< brightness beyond it less that of the floor [grey levels]
};

/// Finds for each column where the floor ends: at the lowest lasting step of brightness that agrees with the
/// neighbouring columns, by dynamic programming. A step lasts if one side is brighter than the other
/// throughout both: tile joints and other thin stripes do not. Keeps its buffers.
class FloorBoundary {
 public:
  explicit FloorBoundary(double contrast_min) : contrast_min_(contrast_min) {}

  /// From left to right; columns that show no end of the floor are left out. Valid until the next call.
  const std::vector<BoundaryPoint>& find(const LevelView& view);

  /// Excludes the step found there from the next `find_again`, as the floor goes on beyond it.
  void exclude(const LevelView& view, const BoundaryPoint& point);
  /// Searches the view of the last `find` again, past the excluded steps.
  const std::vector<BoundaryPoint>& find_again(const LevelView& view);

 private:
  /// Rows in which a step must last over as many rows.
  struct Band {
    int first = 0, end = 0;
    int reach = 0;  ///< half of them
  };

  void set_reaches(const LevelView& view);
  void measure_steps(const LevelView& view, int column);
  void sum_brightness(const std::uint8_t* brightness, LevelView::Rows seen);
  void measure_band(const Band& band, LevelView::Rows seen, float* steps) const;
  void thin(const LevelView& view, int column);
  void weigh(int column);
  void cross_to_next(int column);
  void trace_back(const LevelView& view);
  void add_point(const LevelView& view, int column, int row);

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(column) * static_cast<std::size_t>(rows_) + static_cast<std::size_t>(row);
  }

  double contrast_min_;
  int rows_ = 0;
  std::vector<int> reaches_;         ///< of each row
  std::vector<Band> bands_;          ///< from above
  int cheapest_row_ = 0;             ///< of costs_
  std::vector<int> sums_;            ///< of a column's brightness above a row
  std::vector<float> steps_;         ///< of each column and row; > 0: brighter above
  std::vector<float> costs_;         ///< of the best path to each row of a column
  std::vector<float> crossed_;       ///< the same, after crossing to the next column
  std::vector<std::int16_t> froms_;  ///< for each column and row, the row in the column before
  std::vector<int> path_;
  std::vector<BoundaryPoint> points_;
};

}  // namespace aisle
