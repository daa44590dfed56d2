#pragma once

#include <span>

#include "lines/upright_line.hpp"

namespace aisle {

/// How vertical lines lean across the image of a camera that is tilted or rolled a little: the slope du/dv
/// grows linearly with u. That is one vanishing point, far above or below.
struct VerticalTilt {
  double at_centre = 0;  ///< slope in the middle column
  double per_width = 0;  ///< slope at the right border less slope at the left one

  double slope_at(double u_px, int width_px) const {
    return at_centre + per_width * ((u_px + 0.5) / width_px - 0.5);
  }
};

/// The tilt that most of the lines agree with, by length; every pair of the longest lines is tried. Upright
/// if there are too few lines.
VerticalTilt estimate_tilt(std::span<const UprightLine> lines_longest_first, int width_px);

}  // namespace aisle
