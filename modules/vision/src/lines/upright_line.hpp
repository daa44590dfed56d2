#pragma once

#include "lines/edge_bands.hpp"

namespace aisle {

/// A near-vertical line of the working image: u = u_at(v) from v_top to v_bottom.
struct UprightLine {
  Step step = Step::kBrighter;
  double v_top_px = 0, v_bottom_px = 0;
  double u_middle_px = 0;  ///< at half height
  double slope = 0;        ///< du / dv
  double contrast = 0;     ///< mean of its steps [grey levels]; > 0
  double fill = 0;         ///< share of its bands in which a step was found

  double length_px() const { return v_bottom_px - v_top_px; }
  double u_at(double v_px) const { return u_middle_px + slope * (v_px - 0.5 * (v_top_px + v_bottom_px)); }
};

}  // namespace aisle
