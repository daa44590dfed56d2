#pragma once
/// Poses in the plane. Metres and radians; x forward, y left, heading counter-clockwise (REP 103).
/// T_map_vehicle is the pose of `vehicle` in `map`, and takes points of `vehicle` to points of `map`:
///
///   p_map_corner = T_map_vehicle * p_vehicle_corner;
///   T_map_laser = T_map_vehicle * T_vehicle_laser;

#include <Eigen/Core>
#include <cmath>

#include "aisle/core/angle.hpp"

namespace aisle {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Mat2 = Eigen::Matrix2d;
using Mat3 = Eigen::Matrix3d;

/// `v` turned counter-clockwise.
Vec2 rotate(double angle_rad, const Vec2& v);

/// The matrix that turns counter-clockwise: from a frame's axes to its parent's, of which it has this
/// heading.
Mat2 rotation(double angle_rad);

/// The unit vector with this direction.
Vec2 unit(double angle_rad);

/// The direction of `v` [rad]: what `unit` undoes.
inline double heading_of(const Vec2& v) {
  return std::atan2(v.y(), v.x());
}

/// The turn from one direction to another, left positive, in [-pi, pi).
inline double turn_between(const Vec2& from, const Vec2& to) {
  return wrap_angle(heading_of(to) - heading_of(from));
}

/// The area of the parallelogram from a to b; positive: b points to the left of a.
inline double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// `v` turned by 90 degrees counter-clockwise: the left-hand normal.
inline Vec2 left_normal(const Vec2& v) {
  return {-v.y(), v.x()};
}

struct Pose2 {
  double x = 0;      ///< [m]
  double y = 0;      ///< [m]
  double theta = 0;  ///< heading [rad]; products and inverses are in [-pi, pi)

  Vec2 position() const { return {x, y}; }
  Pose2 inverse() const;
  bool is_finite() const;
};

/// Composition: T_a_c = T_a_b * T_b_c.
Pose2 operator*(const Pose2& a, const Pose2& b);

/// The point in the outer frame.
Vec2 operator*(const Pose2& T, const Vec2& p);

/// T_a_b from both poses in a common frame: inverse(a) * b, without the detour.
Pose2 between(const Pose2& a, const Pose2& b);

/// Between a (share 0) and b (share 1): position on the straight line, heading the short way round.
Pose2 interpolate(const Pose2& a, const Pose2& b, double share);

/// A pose with the covariance of (x, y, theta), in the frame of the pose's parent.
struct UncertainPose2 {
  Pose2 mean;
  Mat3 covariance = Mat3::Zero();
};

/// A pose of which position (in every direction) and heading are known with these deviations.
UncertainPose2 about(const Pose2& T, double sigma_m, double sigma_rad);

/// Composition with first-order propagation; the two are independent.
UncertainPose2 operator*(const UncertainPose2& a, const UncertainPose2& b);

/// First-order propagation through the inverse.
UncertainPose2 inverse(const UncertainPose2& T);

}  // namespace aisle
