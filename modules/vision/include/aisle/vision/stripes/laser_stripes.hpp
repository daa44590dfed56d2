#pragma once
/// The stripes that a line laser draws on walls and obstacles, mostly horizontal in the image.

#include <vector>

#include "aisle/core/image.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

struct StripeParams {
  double contrast_min = 10;
  double noise_factor = 4;
  double white_share = 0.5;
  double width_max_share = 0.04;
  double gradient_min = 0.15;
  double slope_max = 1.5;
  double gap_max_share = 0.01;
  double length_min_share = 0.03;
  double faint_share = 0.2;
  double corner_px = 1.5;

  void describe(FieldList& fields);
};

/// One unbroken stripe, from the left to the right.
struct LaserStripe {
  std::vector<Vec2> points_px;   ///< (column, sub-pixel row); columns increase, few are left out
  std::vector<Vec2> corners_px;  ///< where its straight segments meet, its two ends included: at least two
};

/// Extracts stripes from single images (C99 section 3.1): high brightness and high gradient, linked to
/// polylines that are split into straight segments at corners. The signal of a colour image is its
/// strongest channel, where white light counts less than coloured light; of a grey image, its grey level.
/// Brightness is measured against the surroundings in the same column, so that lamps and bright walls,
/// which are wider than a stripe, do not count. A stripe may slope up to `slope_max`.
/// @return from the left to the right; empty where there is no stripe, or no image
std::vector<LaserStripe> find_laser_stripes(const Image& image, const StripeParams& params = {});

}  // namespace aisle
