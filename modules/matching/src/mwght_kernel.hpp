#pragma once
/// What a vote adds to the cells around its own, and upper bounds of that for boxes of cells.

#include <Eigen/Core>
#include <vector>

#include "aisle/matching/mwght.hpp"

namespace aisle {

/// 1 / (1 + d1 / D0) by the offset of two cells, 0 beyond the reach.
class MwghtKernel {
 public:
  explicit MwghtKernel(const MwghtParams& params);

  int reach() const { return reach_; }  ///< [cells]
  /// For any offset.
  double operator()(int dx, int dy) const {
    if (std::abs(dx) > reach_ || std::abs(dy) > reach_) return 0;
    return row(dy)[dx + reach_];
  }
  /// 2 * reach() + 1 values, for dx = -reach() .. reach(); |dy| <= reach().
  const double* row(int dy) const {
    return &values_[static_cast<std::size_t>((dy + reach_) * (2 * reach_ + 1))];
  }

 private:
  int reach_;
  std::vector<double> values_;
};

/// Upper bounds of what a vote can add to any cell of a box, for boxes of kBox x kBox cells side by side. The
/// first box's corner lies `offset` cells after the vote's own cell.
template <int kBox>
class MwghtBounds {
 public:
  /// @param first_offset  the least offset that is needed
  /// @param offsets  the number of offsets, from there on
  /// @param boxes  the number of boxes along each axis, a multiple of four
  MwghtBounds(const MwghtKernel& kernel, int first_offset, int offsets, int boxes = 4);

  /// The bound of the first box; that of box i of row j is i + j * steps() farther on.
  const float* first(int offset_x, int offset_y) const {
    const auto x = static_cast<unsigned>(offset_x - first_offset_),
               y = static_cast<unsigned>(offset_y - first_offset_);
    const unsigned phase = y % kBox * kBox + x % kBox;
    return &values_[(phase * steps_ + y / kBox) * steps_ + x / kBox];
  }
  std::size_t steps() const { return steps_; }

 private:
  int first_offset_;
  unsigned steps_;  ///< of a whole box, along each axis
  /// By the offset modulo the box, y before x, then by whole boxes: what one vote needs lies together in
  /// memory.
  std::vector<float> values_;
};

}  // namespace aisle
