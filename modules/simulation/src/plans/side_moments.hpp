#pragma once

#include <vector>

#include "aisle/geometry/pose2.hpp"
#include "plans/cell_outlines.hpp"

namespace aisle {

/// Number, mean and spread of the middles of cells' sides.
struct Moments {
  double count = 0;
  Vec2 sum = Vec2::Zero();
  Mat2 outer = Mat2::Zero();  ///< sum of p p^T

  Vec2 mean() const { return sum / count; }
  Mat2 scatter() const { return outer - sum * sum.transpose() / count; }
  /// Sum of squared distances from the line that fits best.
  double squares_off_line() const;
  /// Direction of that line, of length 1.
  Vec2 direction() const;
};

/// Answers for any part of an outline in constant time.
class SideMoments {
 public:
  explicit SideMoments(const Outline& outline);

  /// The sides from corner `first` to corner `last`; both may count on beyond the outline's end, last - first
  /// is at most its number of corners.
  Moments between(std::size_t first, std::size_t last) const;

 private:
  std::vector<Moments> before_;  ///< corner i: the sides from corner 0 to it
};

}  // namespace aisle
