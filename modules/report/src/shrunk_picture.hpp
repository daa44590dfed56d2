#pragma once

#include "aisle/core/image.hpp"

namespace aisle {

/// The picture in another size, each pixel the mean of those it covers. @param scale  above 0, at most 1
Image shrunk(const Image& picture, double scale);

}  // namespace aisle
