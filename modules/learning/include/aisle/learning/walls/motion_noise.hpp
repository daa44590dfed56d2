#pragma once

#include "aisle/core/angle.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// Odometry noise of one step, for any vehicle.
struct MotionNoise {
  double distance_m_per_sqrt_m = 0.05;
  double distance_scale = 0;  ///< relative error of all counted distances, estimated online; 0: none
  double rotation_rad_per_sqrt_m = 0.06;
  double rotation_rad_per_sqrt_rad = 0.03;
  double rotation_share = 0.15;   ///< of the step's own rotation
  double moving_floor_m = 0.003;  ///< least sigma of any step that moves at all
  double moving_floor_rad = 0.002;

  void describe(FieldList& fields);

  /// Covariance of (x, y, theta) of one step, in the frame where it started.
  Mat3 covariance(const Pose2& step) const;
};

/// For wheels that are read in every cycle, with their own scan: an ordinary indoor vehicle, with noise up to
/// three times as large.
inline constexpr MotionNoise kReadEveryCycle{.distance_m_per_sqrt_m = 0.015,
                                             .distance_scale = 0.02,
                                             .rotation_rad_per_sqrt_m = 0.02,
                                             .rotation_rad_per_sqrt_rad = 0.01,
                                             .rotation_share = 0.05,
                                             .moving_floor_m = 0.0005,
                                             .moving_floor_rad = 0.0005};

}  // namespace aisle
