#pragma once
/// The height of the vehicle's laser plane, from its stripe on flat upright targets at known places.

#include <optional>
#include <span>
#include <vector>

#include "aisle/calibration/verdict.hpp"
#include "aisle/geometry/back_projection.hpp"
#include "aisle/geometry/camera_model.hpp"

namespace aisle {

/// A plane in base_link: the points with normal . p = offset_m.
struct TargetPlane {
  Vec3 normal = Vec3::UnitX();  ///< of length 1
  double offset_m = 1;
};

/// An upright wall straight ahead, at right angles to the vehicle's x axis.
TargetPlane wall_ahead(double distance_m);

/// The plane of a board or wall that a chessboard hangs on: through a point, with a normal, both seen from
/// the camera.
TargetPlane plane_seen(const CameraMount& mount, const Vec3& p_camera, const Vec3& normal_camera);

/// What one image shows of the stripe.
struct StripeView {
  TargetPlane target;
  std::vector<Vec2> points_px;  ///< of the stripe; a minority may be something else
};

/// The light plane z = height_m + slope_ahead x + slope_left y in base_link, with standard deviations by the
/// scatter of the points. The mount and the lens are taken as exact.
struct LaserCalibration {
  double height_m = 0;
  double height_deviation_m = 0;
  double slope_ahead = 0, slope_left = 0;
  double slope_ahead_deviation = 0, slope_left_deviation = 0;  ///< 0: not seen, the slope is taken as 0
  double rms_m = 0;                                            ///< of the points that fit, about the plane
  double rms_px = 0;                                           ///< the same, as rows of the images
  std::size_t points = 0;                                      ///< that fit
  std::size_t points_seen = 0;                                 ///< that meet their targets
  CalibrationVerdict verdict;
};

inline constexpr std::size_t kStripePointsMin = 20;

/// The slope ahead is found where the targets' distances differ by a fifth at least, the slope to the left
/// where the points reach over a fifth of their distance.
/// @return nullopt if fewer than kStripePointsMin points agree on a plane
std::optional<LaserCalibration> calibrate_laser(std::span<const StripeView> views, const CameraModel& lens,
                                                const CameraMount& mount);

/// What the figures of a calibration mean.
CalibrationVerdict judge(const LaserCalibration& calibration);

}  // namespace aisle
