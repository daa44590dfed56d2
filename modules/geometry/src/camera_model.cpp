#include "aisle/geometry/camera_model.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "lens_distortion.hpp"

namespace aisle {
namespace {

const CameraIntrinsics& checked(const CameraIntrinsics& c) {
  const std::array values{c.fx_px, c.fy_px, c.cx_px, c.cy_px, c.k1, c.k2, c.p1, c.p2, c.k3, c.k4, c.k5, c.k6};
  const bool all_finite =
      std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
  if (!all_finite || c.fx_px <= 0 || c.fy_px <= 0) {
    throw std::invalid_argument("CameraModel: all intrinsics must be finite, fx_px and fy_px positive");
  }
  return c;
}

}  // namespace

CameraModel::CameraModel(const CameraIntrinsics& intrinsics)
    : intrinsics_(checked(intrinsics)), fold_slope_squared_(fold_slope_squared(intrinsics)) {}

double CameraModel::half_field_of_view_rad() const {
  return std::atan(std::sqrt(fold_slope_squared_));
}

bool CameraModel::is_one_to_one(const Vec2& slopes) const {
  return slopes.squaredNorm() < fold_slope_squared_ &&
         distorted(intrinsics_, slopes).by_slopes.determinant() > 0;
}

std::optional<Vec2> CameraModel::project(const Vec3& p_camera) const {
  if (!(p_camera.z() > 0)) return std::nullopt;
  const Vec2 slopes = p_camera.head<2>() / p_camera.z();
  if (!is_one_to_one(slopes)) return std::nullopt;
  const Vec2 bent = distorted(intrinsics_, slopes).slopes;
  return Vec2(intrinsics_.fx_px * bent.x() + intrinsics_.cx_px,
              intrinsics_.fy_px * bent.y() + intrinsics_.cy_px);
}

std::optional<Vec2> CameraModel::undistorted(const Vec2& distorted_slopes) const {
  constexpr int kMaxRounds = 50;
  constexpr double kTolerance = 1e-12, kShortestStep = 1e-15;
  Vec2 slopes = Vec2::Zero();
  for (int round = 0; round < kMaxRounds; ++round) {
    const DistortedSlopes here = distorted(intrinsics_, slopes);
    const Vec2 missing = distorted_slopes - here.slopes;
    if (missing.norm() < kTolerance) return slopes;
    Vec2 step = here.by_slopes.inverse() * missing;
    const auto is_better = [&](const Vec2& there) {
      return is_one_to_one(there) &&
             (distorted_slopes - distorted(intrinsics_, there).slopes).norm() < missing.norm();
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
                  distorted(intrinsics_, *slopes).by_slopes.inverse() * by_focal.asDiagonal()};
}

}  // namespace aisle
