#pragma once

#include "aisle/core/image.hpp"
#include "aisle/vision/lines/vertical_lines.hpp"

namespace aisle {

/// Column of a line, or of its continuation, at a height.
double u_at(const VerticalLine& line, double v_px);

/// Mean step across a line between two heights, in the direction of its own.
double contrast_between(const Image& grey, const VerticalLine& line, double top_px, double bottom_px);

}  // namespace aisle
