#pragma once

#include <array>

#include "aisle/core/image.hpp"

namespace aisle {

/// Where an image's columns are brightest and darkest, in its upper, lower, left and right half: upper max,
/// upper min, lower max, ... as shares of the half's width from its left (L96 Algorithm 2).
/// @param image  not empty
std::array<double, 8> brightness_view(const Image& image);

}  // namespace aisle
