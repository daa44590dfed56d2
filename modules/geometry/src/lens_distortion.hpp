#pragma once

#include "aisle/geometry/camera_model.hpp"

namespace aisle {

/// Slopes (x / z, y / z) after the distortion, with their derivative by the slopes before it.
struct DistortedSlopes {
  Vec2 slopes;
  Mat2 by_slopes;
};

DistortedSlopes distorted(const CameraIntrinsics& lens, const Vec2& slopes);

/// The square of the slope at which the distorted radius stops growing: there the polynomials fold back and
/// describe no lens any more. At most that of 84 degrees off the axis, with an equidistant lens of 89.
double fold_slope_squared(const CameraIntrinsics& lens);

}  // namespace aisle
