#pragma once

#include <cmath>

namespace aisle {

/// Weight of a residual in least squares under Cauchy's loss: 1 at 0, 1/2 at `scale`, ever less beyond.
inline double cauchy_weight(double residual, double scale) {
  return 1 / (1 + residual * residual / (scale * scale));
}

/// The same as a factor on the residual's standard deviation: 1 / sqrt(weight).
inline double cauchy_distrust(double residual, double scale) {
  return std::hypot(1, residual / scale);
}

}  // namespace aisle
