#include "aisle/geometry/pose2.hpp"

#include <cmath>

#include "aisle/core/angle.hpp"
#include "aisle/core/square.hpp"

namespace aisle {

Vec2 rotate(double angle_rad, const Vec2& v) {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}

Mat2 rotation(double angle_rad) {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  return Mat2{{c, -s}, {s, c}};
}

Vec2 unit(double angle_rad) {
  return {std::cos(angle_rad), std::sin(angle_rad)};
}

Pose2 Pose2::inverse() const {
  const Vec2 p = rotate(-theta, -position());
  return {p.x(), p.y(), wrap_angle(-theta)};
}

bool Pose2::is_finite() const {
  return std::isfinite(x) && std::isfinite(y) && std::isfinite(theta);
}

Pose2 operator*(const Pose2& a, const Pose2& b) {
  const Vec2 p = a * b.position();
  return {p.x(), p.y(), wrap_angle(a.theta + b.theta)};
}

Vec2 operator*(const Pose2& T, const Vec2& p) {
  return rotate(T.theta, p) + T.position();
}

Pose2 between(const Pose2& a, const Pose2& b) {
  const Vec2 p = rotate(-a.theta, b.position() - a.position());
  return {p.x(), p.y(), wrap_angle(b.theta - a.theta)};
}

Pose2 interpolate(const Pose2& a, const Pose2& b, double share) {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y),
          wrap_angle(a.theta + share * wrap_angle(b.theta - a.theta))};
}

UncertainPose2 about(const Pose2& T, double sigma_m, double sigma_rad) {
  return {T, Vec3(square(sigma_m), square(sigma_m), square(sigma_rad)).asDiagonal()};
}

UncertainPose2 operator*(const UncertainPose2& a, const UncertainPose2& b) {
  const Vec2 lever = rotate(a.mean.theta, b.mean.position());
  Mat3 by_a = Mat3::Identity();
  by_a.block<2, 1>(0, 2) = left_normal(lever);
  Mat3 by_b = Mat3::Identity();
  by_b.topLeftCorner<2, 2>() = rotation(a.mean.theta);
  return {a.mean * b.mean, by_a * a.covariance * by_a.transpose() + by_b * b.covariance * by_b.transpose()};
}

UncertainPose2 inverse(const UncertainPose2& T) {
  const Pose2 inverted = T.mean.inverse();
  Mat3 jacobian = -Mat3::Identity();
  jacobian.topLeftCorner<2, 2>() = -rotation(-T.mean.theta);
  jacobian.block<2, 1>(0, 2) = -left_normal(inverted.position());
  return {inverted, jacobian * T.covariance * jacobian.transpose()};
}

}  // namespace aisle
