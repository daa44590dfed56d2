#pragma once

#include <span>
#include <vector>

#include "stripes/stripe_peaks.hpp"

namespace aisle {

struct LinkLimits {
  int gap_max_px = 0;    ///< columns that a stripe may skip
  double slope_max = 0;  ///< rows per column
};

/// Peaks of neighbouring columns in a row, from the left to the right.
using PeakChain = std::vector<StripePeak>;

/// Links peaks, given by column, to chains that run on smoothly. Each peak is in one chain.
std::vector<PeakChain> link_stripe_peaks(std::span<const StripePeak> peaks, const LinkLimits& limits);

}  // namespace aisle
