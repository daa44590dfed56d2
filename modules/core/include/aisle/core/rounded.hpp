#pragma once

#include <cmath>

namespace aisle {

/// Rounds a figure to a number of decimals.
inline double rounded(double value, int decimals) {
  const double scale = std::pow(10, decimals);
  return std::round(value * scale) / scale;
}

}  // namespace aisle
