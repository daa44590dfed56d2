#pragma once

#include <cstddef>
#include <span>

#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// Length from each point to the next, summed; 0 for fewer than two points.
inline double polyline_length_m(std::span<const Vec2> points) {
  double sum_m = 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum_m += (points[i] - points[i - 1]).norm();
  return sum_m;
}

}  // namespace aisle
