#pragma once

#include "image_sequences/image_list.hpp"

namespace aisle {

/// Stamps are from 0 to this.
inline constexpr double kStampMax_s = 2147483647;
/// From one image to the next: a double of today's date does not tell less apart.
inline constexpr double kStampStepMin_s = 1e-6;

/// Makes every stamp later than the one before. Where a clock steps back or stands still, the usual (median)
/// step is taken, and all later stamps move with it; the order of recording stays. One warning tells so.
/// @return problems if no stamp is later than another, or if they leave the range of stamps
Problems order_stamps(ImageList& list);

}  // namespace aisle
