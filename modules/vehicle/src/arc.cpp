#include "aisle/vehicle/arc.hpp"

#include <cmath>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

/// sin(a) / a
double sinc(double a) {
  return a == 0 ? 1 : std::sin(a) / a;
}

/// Derivative of sinc; the closed form loses its digits near 0, the series is exact there to the last bit.
double sinc_slope(double a) {
  const double q = a * a;
  if (q < 1e-4) return a * (-1.0 / 3 + q * (1.0 / 30 - q / 840));
  return (std::cos(a) - sinc(a)) / a;
}

}  // namespace

Pose2 end_pose(const Arc& arc) {
  const double half_turn = arc.turn_rad / 2;
  const Vec2 chord =
      arc.length_m * sinc(half_turn) * unit(half_turn);  // C99 eq. (3), (4), without the radius
  return {chord.x(), chord.y(), wrap_angle(arc.turn_rad)};
}

Mat32 end_pose_jacobian(const Arc& arc) {
  const double half_turn = arc.turn_rad / 2;
  const Vec2 along = unit(half_turn), across = left_normal(along);
  Mat32 jacobian;
  jacobian.topLeftCorner<2, 1>() = sinc(half_turn) * along;
  jacobian.topRightCorner<2, 1>() =
      arc.length_m / 2 * (sinc_slope(half_turn) * along + sinc(half_turn) * across);
  jacobian.row(2) << 0, 1;
  return jacobian;
}

}  // namespace aisle
