#pragma once

#include <array>

#include "aisle/core/image.hpp"

namespace aisle {

/// Where a picture's columns are brightest and darkest, in its upper, lower, left and right half: upper max,
/// upper min, lower max, ... as shares of the half's width from its left (L96 Algorithm 2).
/// @param picture  not empty
std::array<double, 8> brightness_view(const Image& picture);

}  // namespace aisle
