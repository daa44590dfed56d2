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

/// The most that a vote can add to any cell of a box, for boxes of kBox x kBox cells side by side. The first
/// box's corner lies `offset` cells after the vote's own cell.
template <int kBox>
class MwghtBounds {
 public:
  /// @param first_offset  the least offset that is asked for
  /// @param offsets  how many offsets are, from there on
  /// @param boxes  how many boxes are asked for along each axis, a multiple of four
  MwghtBounds(const MwghtKernel& kernel, int first_offset, int offsets, int boxes = 4);

  /// For the boxes i .. i + 3 of row j.
  auto four(int offset_x, int offset_y, int j, int i = 0) const {
    const unsigned x = static_cast<unsigned>(offset_x - first_offset_);
    const unsigned y = static_cast<unsigned>(offset_y - first_offset_ + j * kBox);
    return Eigen::Array4f::Map(
        &values_[(y * kBox + x % kBox) * quotients_ + x / kBox + static_cast<unsigned>(i)]);
  }

 private:
  int first_offset_;
  unsigned quotients_;
  /// By (row, column modulo the box, column by the box): what lies side by side in the boxes lies so in
  /// memory.
  std::vector<float> values_;
};

}  // namespace aisle
