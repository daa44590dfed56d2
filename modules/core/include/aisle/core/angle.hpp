#pragma once
/// Angles are radians, counter-clockwise; degrees appear in files, flags and printed text only.

#include <cmath>
#include <numbers>

namespace aisle {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kDegree = kPi / 180;

constexpr double to_degrees(double angle_rad) {
  return angle_rad / kDegree;
}

/// The same direction in [-pi, pi).
inline double wrap_angle(double angle_rad) {
  if (angle_rad >= -kPi && angle_rad < kPi) return angle_rad;
  return angle_rad - 2 * kPi * std::floor((angle_rad + kPi) / (2 * kPi));
}

/// The angle modulo 90 degrees in [-pi/4, pi/4): how far a direction is from the nearest axis of its frame.
inline double wrap_quarter_turn(double angle_rad) {
  return angle_rad - kPi / 2 * std::floor((angle_rad + kPi / 4) / (kPi / 2));
}

}  // namespace aisle
