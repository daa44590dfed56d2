#pragma once

#include <cmath>

#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// Unit vector along which points spread most; its sign is arbitrary.
/// @param spread  symmetric: the sum, or mean, of p p^T over the points, p measured from a point on their
/// line
inline Vec2 principal_direction(const Mat2& spread) {
  return unit(std::atan2(2 * spread(0, 1), spread(0, 0) - spread(1, 1)) / 2);
}

}  // namespace aisle
