#pragma once
/// Matchers for poses: a failure prints metres and degrees.

#include <gmock/gmock.h>

#include <cmath>
#include <ostream>

#include "aisle/core/angle.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

inline void PrintTo(const Pose2& pose, std::ostream* out) {
  *out << "(" << pose.x << " m, " << pose.y << " m, " << to_degrees(pose.theta) << " deg)";
}

MATCHER_P3(PoseNear, expected, tolerance_m, tolerance_rad,
           "is within " + testing::PrintToString(tolerance_m) + " m and " +
               testing::PrintToString(to_degrees(tolerance_rad)) + " deg of " +
               testing::PrintToString(expected)) {
  const double off_m = std::hypot(arg.x - expected.x, arg.y - expected.y);
  const double off_rad = std::abs(wrap_angle(arg.theta - expected.theta));
  *result_listener << "which is " << off_m << " m and " << to_degrees(off_rad) << " deg away";
  return off_m <= tolerance_m && off_rad <= tolerance_rad;
}

MATCHER_P2(PointNear, expected, tolerance_m,
           "is within " + testing::PrintToString(tolerance_m) + " m of (" +
               testing::PrintToString(expected.x()) + ", " + testing::PrintToString(expected.y()) + ")") {
  const double off_m = (arg - expected).norm();
  *result_listener << "which is " << off_m << " m away";
  return off_m <= tolerance_m;
}

}  // namespace aisle
