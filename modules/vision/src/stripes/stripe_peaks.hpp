#pragma once

#include <vector>

#include "aisle/core/image.hpp"

namespace aisle {

/// A bright run of pixels in one column.
struct StripePeak {
  int column = 0;
  double row = 0;  ///< its centre of brightness
  double contrast = 0;
};

struct PeakLimits {
  int contrast_min = 0;
  int width_max_px = 0;
  double gradient_min = 0;  ///< steepest step on either flank, as a share of the peak
};

/// The peaks of each column's contrast, by column and then by row.
std::vector<StripePeak> find_stripe_peaks(const Image& contrast, const PeakLimits& limits);

}  // namespace aisle
