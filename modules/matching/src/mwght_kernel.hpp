#pragma once
/// What a vote adds to the cells around its own, and bounds of it for boxes of cells.

#include <Eigen/Core>
#include <vector>

#include "aisle/matching/mwght.hpp"

namespace aisle {

/// 1 / (1 + d1 / D0) by the offset of two cells, 0 beyond the reach.
class MwghtKernel {
 public:
  explicit MwghtKernel(const MwghtParams& params);

  int reach() const { return reach_; }  ///< [cells]
  /// Any offset.
  double operator()(int dx, int dy) const {
    if (std::abs(dx) > reach_ || std::abs(dy) > reach_) return 0;
    return row(dy)[dx + reach_];
  }
  /// 2 * reach() + 1 values, for dx = -reach() ..; |dy| <= reach().
  const double* row(int dy) const {
    return &values_[static_cast<std::size_t>((dy + reach_) * (2 * reach_ + 1))];
  }

 private:
  int reach_;
  std::vector<double> values_;
};

/// The most that a vote can add to any cell of a box, for rows of boxes side by side: boxes of `box` x `box`
/// cells, whose first corner lies `offset` cells after the vote's own cell.
class MwghtBounds {
 public:
  /// @param first_offset  the least offset that is asked for
  /// @param offsets  how many offsets are, from there on
  /// @param boxes  how many boxes side by side; they are read in fours
  MwghtBounds(const MwghtKernel& kernel, int box, int first_offset, int offsets, int boxes);

  int boxes() const { return boxes_; }  ///< side by side, a multiple of four

  /// For the boxes number i .. i + 3 of row j, the first of which has the given offset.
  auto four(int offset_x, int offset_y, int i, int j) const {
    const int x = offset_x - first_offset_, y = offset_y - first_offset_ + j * box_;
    return Eigen::Array4f::Map(
        &values_[static_cast<std::size_t>((y * box_ + x % box_) * quotients_ + x / box_ + i)]);
  }

 private:
  int box_, first_offset_, boxes_, quotients_;
  /// By (row, column modulo the box, column by the box): what lies side by side in the boxes lies so in
  /// memory.
  std::vector<float> values_;
};

}  // namespace aisle
