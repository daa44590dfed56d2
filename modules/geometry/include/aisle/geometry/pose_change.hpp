#pragma once
/// Small changes of a pose as vectors (x, y, heading), as filters and least squares use them.

#include "aisle/core/angle.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// The pose moved by a change of (x, y, theta) in the frame of its parent.
inline Pose2 moved_by(const Pose2& pose, const Vec3& change) {
  return {pose.x + change(0), pose.y + change(1), wrap_angle(pose.theta + change(2))};
}

/// The change that moves one pose to the other.
inline Vec3 change_between(const Pose2& from, const Pose2& to) {
  return {to.x - from.x, to.y - from.y, wrap_angle(to.theta - from.theta)};
}

}  // namespace aisle
