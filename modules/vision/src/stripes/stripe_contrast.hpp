#pragma once

#include "aisle/core/image.hpp"

namespace aisle {

/// How much each pixel of the strongest channel stands out from what is above and below it, less
/// `white_share` of what stands out in the weakest channel too; structures of `width_px` rows or more do not
/// stand out. A white top hat: the image minus its opening along the columns.
Image stripe_contrast(const Image& image, int width_px, double white_share);

}  // namespace aisle
