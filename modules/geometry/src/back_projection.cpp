#include "aisle/geometry/back_projection.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace aisle {
namespace {

/// The camera's axes (right, down, forward) in a vehicle that looks ahead (forward, left, up).
Mat3 looking_ahead() {
  Mat3 rotation;
  rotation << 0, 0, 1,  //
      -1, 0, 0,         //
      0, -1, 0;
  return rotation;
}

}  // namespace

Mat3 CameraMount::R_vehicle_camera() const {
  using Eigen::AngleAxisd;
  return AngleAxisd(pan_rad, Vec3::UnitZ()) * AngleAxisd(tilt_rad, Vec3::UnitY()) *
         AngleAxisd(roll_rad, Vec3::UnitX()).toRotationMatrix() * looking_ahead();
}

Vec3 CameraMount::to_camera(const Vec3& p_vehicle) const {
  return R_vehicle_camera().transpose() * (p_vehicle - p_vehicle_camera);
}

void BackProjectionNoise::describe(FieldList& fields) {
  fields.real("pixel_px", pixel_px, {0, 100}, "error of each pixel coordinate");
  fields.angle("tilt_deg", tilt_rad, {0, 45}, "error of the camera's tilt, by calibration and shaking");
}

BackProjection::BackProjection(const CameraModel& camera, const CameraMount& mount, double plane_height_m)
    : camera_(camera),
      mount_(mount),
      R_vehicle_camera_(mount.R_vehicle_camera()),
      plane_height_m_(plane_height_m) {}

/// Multiple of the ray that leads from the lens to the plane.
std::optional<double> BackProjection::ray_length(const Vec3& ray) const {
  constexpr double kLevel = 1e-9;
  if (std::abs(ray.z()) <= kLevel * ray.norm()) return std::nullopt;
  const double length = (plane_height_m_ - mount_.p_vehicle_camera.z()) / ray.z();
  if (!(length > 0)) return std::nullopt;
  return length;
}

std::optional<Vec2> BackProjection::point(const Vec2& pixel_px) const {
  const auto pixel_ray = camera_.ray(pixel_px);
  if (!pixel_ray) return std::nullopt;
  const Vec3 ray = R_vehicle_camera_ * pixel_ray->direction;
  const auto length = ray_length(ray);
  if (!length) return std::nullopt;
  return Vec2(mount_.p_vehicle_camera.head<2>() + *length * ray.head<2>());
}

std::optional<UncertainPoint2> BackProjection::uncertain_point(const Vec2& pixel_px,
                                                               const BackProjectionNoise& noise) const {
  const auto pixel_ray = camera_.ray(pixel_px);
  if (!pixel_ray) return std::nullopt;
  const Vec3 ray = R_vehicle_camera_ * pixel_ray->direction;
  const auto length = ray_length(ray);
  if (!length) return std::nullopt;

  // The ray's derivatives by (u, v, tilt), each times its error: a column is what one standard deviation
  // does.
  const Vec3 tilt_axis{-std::sin(mount_.pan_rad), std::cos(mount_.pan_rad), 0};
  Mat3 ray_errors;
  ray_errors.leftCols<2>() = R_vehicle_camera_.leftCols<2>() * pixel_ray->by_pixel * noise.pixel_px;
  ray_errors.col(2) = tilt_axis.cross(ray) * noise.tilt_rad;
  if (std::abs(ray.z()) <= 3 * ray_errors.row(2).norm()) return std::nullopt;

  // The point slides along the ray's trace on the plane as the ray rises.
  Eigen::Matrix<double, 2, 3> point_by_ray;
  point_by_ray << Mat2::Identity(), -ray.head<2>() / ray.z();
  const Eigen::Matrix<double, 2, 3> point_errors = *length * point_by_ray * ray_errors;
  return UncertainPoint2{mount_.p_vehicle_camera.head<2>() + *length * ray.head<2>(),
                         point_errors * point_errors.transpose()};
}

}  // namespace aisle
