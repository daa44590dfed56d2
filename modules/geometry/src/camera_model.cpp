#include "aisle/geometry/camera_model.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace aisle {
namespace {

constexpr double kWidestSlopeSquared = 100;  // 84 degrees off the axis

const CameraIntrinsics& checked(const CameraIntrinsics& c) {
  const std::array values{c.fx_px, c.fy_px, c.cx_px, c.cy_px, c.k1, c.k2, c.p1, c.p2, c.k3};
  const bool all_finite =
      std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
  if (!all_finite || c.fx_px <= 0 || c.fy_px <= 0) {
    throw std::invalid_argument("CameraModel: all intrinsics must be finite, fx_px and fy_px positive");
  }
  return c;
}

/// How fast the distorted radius grows with the radius, at radius^2 = q.
double radial_growth(const CameraIntrinsics& c, double q) {
  return 1 + q * (3 * c.k1 + q * (5 * c.k2 + q * 7 * c.k3));
}

/// Where the growth, a cubic in q, has its extremes; NaN where it has none.
std::array<double, 2> growth_extremes(const CameraIntrinsics& c) {
  const double a = 21 * c.k3, half_b = 5 * c.k2, e = 3 * c.k1;  // a q^2 + 2 half_b q + e = 0
  const double root = std::sqrt(half_b * half_b - a * e);
  const double far = -(half_b + std::copysign(root, half_b));
  return {far / a, e / far};
}

/// The smallest radius^2 at which the distorted radius stops growing; kWidestSlopeSquared if it grows so far.
double fold_radius_squared(const CameraIntrinsics& c) {
  std::array<double, 3> checks{kWidestSlopeSquared, kWidestSlopeSquared, kWidestSlopeSquared};
  const auto extremes = growth_extremes(c);
  std::copy_if(extremes.begin(), extremes.end(), checks.begin(),
               [](double q) { return q > 0 && q < kWidestSlopeSquared; });
  std::sort(checks.begin(), checks.end());
  double growing = 0;
  for (double check : checks) {
    if (radial_growth(c, check) > 0) {
      growing = check;
      continue;
    }
    double folded = check;
    while (folded - growing > 1e-12 * folded) {
      const double middle = (growing + folded) / 2;
      (radial_growth(c, middle) > 0 ? growing : folded) = middle;
    }
    return growing;
  }
  return kWidestSlopeSquared;
}

}  // namespace

/// Slopes after the distortion, with their derivative by the slopes before it.
struct CameraModel::Distorted {
  Vec2 slopes;
  Mat2 by_slopes;
};

CameraModel::CameraModel(const CameraIntrinsics& intrinsics)
    : intrinsics_(checked(intrinsics)), fold_radius_squared_(fold_radius_squared(intrinsics)) {}

CameraModel::Distorted CameraModel::distorted(const Vec2& slopes) const {
  const auto& [fx, fy, cx, cy, k1, k2, p1, p2, k3] = intrinsics_;
  const double x = slopes.x(), y = slopes.y(), q = x * x + y * y;
  const double radial = 1 + q * (k1 + q * (k2 + q * k3));
  const double twice_radial_by_q = 2 * (k1 + q * (2 * k2 + q * 3 * k3));
  const double mixed = x * y * twice_radial_by_q + 2 * p1 * x + 2 * p2 * y;
  Distorted result;
  result.slopes = {x * radial + 2 * p1 * x * y + p2 * (q + 2 * x * x),
                   y * radial + p1 * (q + 2 * y * y) + 2 * p2 * x * y};
  result.by_slopes << radial + x * x * twice_radial_by_q + 2 * p1 * y + 6 * p2 * x, mixed,  //
      mixed, radial + y * y * twice_radial_by_q + 6 * p1 * y + 2 * p2 * x;
  return result;
}

bool CameraModel::is_one_to_one(const Vec2& slopes) const {
  return slopes.squaredNorm() < fold_radius_squared_ && distorted(slopes).by_slopes.determinant() > 0;
}

std::optional<Vec2> CameraModel::project(const Vec3& p_camera) const {
  if (!(p_camera.z() > 0)) return std::nullopt;
  const Vec2 slopes = p_camera.head<2>() / p_camera.z();
  if (!is_one_to_one(slopes)) return std::nullopt;
  const Vec2 bent = distorted(slopes).slopes;
  return Vec2(intrinsics_.fx_px * bent.x() + intrinsics_.cx_px,
              intrinsics_.fy_px * bent.y() + intrinsics_.cy_px);
}

std::optional<Vec2> CameraModel::undistorted(const Vec2& distorted_slopes) const {
  constexpr int kMaxRounds = 50;
  constexpr double kTolerance = 1e-12, kShortestStep = 1e-15;
  Vec2 slopes = Vec2::Zero();
  for (int round = 0; round < kMaxRounds; ++round) {
    const Distorted here = distorted(slopes);
    const Vec2 missing = distorted_slopes - here.slopes;
    if (missing.norm() < kTolerance) return slopes;
    Vec2 step = here.by_slopes.inverse() * missing;
    const auto is_better = [&](const Vec2& there) {
      return is_one_to_one(there) && (distorted_slopes - distorted(there).slopes).norm() < missing.norm();
    };
    while (!is_better(slopes + step)) {
      step /= 2;
      if (step.norm() < kShortestStep) return std::nullopt;
    }
    slopes += step;
  }
  return std::nullopt;
}

std::optional<PixelRay> CameraModel::ray(const Vec2& pixel_px) const {
  if (!pixel_px.allFinite()) return std::nullopt;
  const Vec2 distorted_slopes{(pixel_px.x() - intrinsics_.cx_px) / intrinsics_.fx_px,
                              (pixel_px.y() - intrinsics_.cy_px) / intrinsics_.fy_px};
  const auto slopes = undistorted(distorted_slopes);
  if (!slopes) return std::nullopt;
  const Vec2 by_focal{1 / intrinsics_.fx_px, 1 / intrinsics_.fy_px};
  return PixelRay{Vec3(slopes->x(), slopes->y(), 1),
                  distorted(*slopes).by_slopes.inverse() * by_focal.asDiagonal()};
}

}  // namespace aisle
