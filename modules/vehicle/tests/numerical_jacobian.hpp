#pragma once

#include "aisle/core/angle.hpp"
#include "aisle/vehicle/arc.hpp"

namespace aisle {

/// Derivative of a pose by two quantities, from central differences.
template <class PoseOf>
Mat32 numerical_jacobian(PoseOf pose_of, const Vec2& at, double step = 1e-6) {
  Mat32 jacobian;
  for (int i = 0; i < 2; ++i) {
    const Vec2 nudge = step * Vec2::Unit(i);
    const Pose2 plus = pose_of(at + nudge), minus = pose_of(at - nudge);
    jacobian.col(i) << plus.x - minus.x, plus.y - minus.y, wrap_angle(plus.theta - minus.theta);
  }
  return jacobian / (2 * step);
}

}  // namespace aisle
