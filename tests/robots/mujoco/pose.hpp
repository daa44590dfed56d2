#pragma once

#include <cmath>
#include <numbers>

namespace robots {

inline double to_radians(double angle_deg) {
  return angle_deg * std::numbers::pi / 180;
}
inline double to_degrees(double angle_rad) {
  return angle_rad * 180 / std::numbers::pi;
}

/// A pose on the floor; products of neighbouring frames: `T_a_c = T_a_b * T_b_c`.
struct Pose2 {
  double x = 0;
  double y = 0;
  double heading_rad = 0;

  friend Pose2 operator*(const Pose2& T_a_b, const Pose2& T_b_c) {
    const double c = std::cos(T_a_b.heading_rad), s = std::sin(T_a_b.heading_rad);
    return {T_a_b.x + c * T_b_c.x - s * T_b_c.y, T_a_b.y + s * T_b_c.x + c * T_b_c.y,
            T_a_b.heading_rad + T_b_c.heading_rad};
  }
};

}  // namespace robots
