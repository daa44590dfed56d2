#pragma once
/// How a camera maps directions to pixels: pinhole or fisheye, with the lens's distortion.
/// Points are in camera_optical (z forward, x right, y down). Pixel (0, 0) is the CENTRE of the top-left
/// pixel, u to the right, v down.

#include <optional>

#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// How the lens bends; OpenCV's and ROS's models and symbols.
enum class LensModel {
  kPlumbBob,            ///< Brown-Conrady: k1, k2, k3 radial, p1, p2 tangential
  kRationalPolynomial,  ///< the same, divided by 1 + k4 r^2 + k5 r^4 + k6 r^6
  kEquidistant,         ///< Kannala-Brandt, for fisheye lenses: k1 to k4 by the angle; p1, p2, k5, k6 unused
};

struct CameraIntrinsics {
  double fx_px = 500, fy_px = 500;  ///< focal lengths; > 0
  double cx_px = 320, cy_px = 240;  ///< where the optical axis meets the image
  double k1 = 0, k2 = 0;            ///< radial distortion
  double p1 = 0, p2 = 0;            ///< tangential distortion
  double k3 = 0;                    ///< radial again, in OpenCV's order
  LensModel model = LensModel::kPlumbBob;
  double k4 = 0, k5 = 0, k6 = 0;  ///< of the other models

  friend bool operator==(const CameraIntrinsics&, const CameraIntrinsics&) = default;
};

/// Where a pixel looks.
struct PixelRay {
  Vec3 direction = Vec3::UnitZ();  ///< in camera_optical, with z = 1
  Mat2 by_pixel = Mat2::Zero();    ///< derivative of its x and y by (u, v) [1/px]
};

class CameraModel {
 public:
  /// @throws std::invalid_argument unless all values are finite and the focal lengths positive
  explicit CameraModel(const CameraIntrinsics& intrinsics);

  /// The pixel that sees a point.
  /// @return nullopt if the point is not in front of the camera, or farther off the axis than
  ///         half_field_of_view_rad()
  std::optional<Vec2> project(const Vec3& p_camera) const;

  /// The one direction that `project` takes to this pixel, by damped Newton iteration to 1e-12 of the focal
  /// length; a few rounds for usual lenses.
  /// @return nullopt if the pixel is not finite, if no direction is projected to it, or if it is so close to
  ///         a fold that the iteration stalls; never a wrong ray
  std::optional<PixelRay> ray(const Vec2& pixel_px) const;

  /// The angle off the optical axis up to which the model is valid: where its polynomials fold back and
  /// describe no lens any more, but at most 84 degrees, 89 with an equidistant lens.
  double half_field_of_view_rad() const;

 private:
  bool is_one_to_one(const Vec2& slopes) const;
  std::optional<Vec2> undistorted(const Vec2& distorted_slopes) const;

  CameraIntrinsics intrinsics_;
  double fold_slope_squared_;
};

}  // namespace aisle
