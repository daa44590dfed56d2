#pragma once

#include <cmath>

#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// A unit along which points spread most, by either sign.
/// @param spread  symmetric: the sum, or mean, of p p^T over the points, p from a place on their line
inline Vec2 principal_direction(const Mat2& spread) {
  return unit(std::atan2(2 * spread(0, 1), spread(0, 0) - spread(1, 1)) / 2);
}

}  // namespace aisle
