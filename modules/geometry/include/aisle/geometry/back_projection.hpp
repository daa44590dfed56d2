#pragma once
/// Where a pixel's ray meets a level plane: a point of a wall-floor edge on the floor (C98), of a laser
/// stripe at the height h0 (C99 section 3.1). One pixel is enough because the plane is known.

#include <optional>

#include "aisle/core/angle.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/geometry/camera_model.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// How a camera sits on the vehicle. Turned from "level, looking ahead" by roll, then tilt, then pan, each
/// about an axis of base_link.
struct CameraMount {
  Vec3 p_vehicle_camera{0, 0, 1};  ///< the lens centre: ahead, to the left, height above the floor [m]
  double tilt_rad = 0;             ///< looking down positive
  double pan_rad = 0;              ///< looking to the left positive
  double roll_rad = 0;  ///< leaning to the right positive: a level edge in view slopes up to the right

  /// Takes directions of camera_optical to directions of base_link.
  Mat3 R_vehicle_camera() const;
  /// A point of base_link in camera_optical.
  Vec3 to_camera(const Vec3& p_vehicle) const;
};

/// Errors of what a point is computed from: standard deviations, independent of each other.
struct BackProjectionNoise {
  double pixel_px = 0.5;            ///< of each pixel coordinate
  double tilt_rad = 0.2 * kDegree;  ///< of the camera about its lens centre, as the vehicle shakes

  void describe(FieldList& fields);
};

/// A point of the plane with the covariance of (x, y).
struct UncertainPoint2 {
  Vec2 mean = Vec2::Zero();
  Mat2 covariance = Mat2::Zero();
};

/// One camera looking at one plane z = h of the vehicle frame, above or below the lens.
class BackProjection {
 public:
  BackProjection(const CameraModel& camera, const CameraMount& mount, double plane_height_m);

  /// The point of the plane that the pixel sees, in base_link [m].
  /// @return nullopt if the ray is level or leads away from the plane (for the floor: at or above the
  ///         horizon), or if the camera model has no ray for the pixel
  std::optional<Vec2> point(const Vec2& pixel_px) const;

  /// The same with first-order covariance, which grows with the distance (C98 eq. (4), Figs. 4, 5).
  /// @return nullopt also if the horizon is within three standard deviations of the ray: then the point may
  ///         be anywhere, and a covariance would not describe it
  std::optional<UncertainPoint2> uncertain_point(const Vec2& pixel_px,
                                                 const BackProjectionNoise& noise) const;

 private:
  std::optional<double> ray_length(const Vec3& ray) const;

  CameraModel camera_;
  CameraMount mount_;
  Mat3 R_vehicle_camera_;
  double plane_height_m_;
};

}  // namespace aisle
