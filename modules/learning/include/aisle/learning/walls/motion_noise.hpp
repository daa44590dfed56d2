#pragma once

#include "aisle/core/angle.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// How far odometry may be off over one step, whatever the vehicle.
struct MotionNoise {
  double distance_m_per_sqrt_m = 0.05;
  double distance_scale = 0;  ///< share by which all paths may be counted wrong, learned on the way; 0: none
  double rotation_rad_per_sqrt_m = 0.06;
  double rotation_rad_per_sqrt_rad = 0.03;
  double rotation_share = 0.15;   ///< of the step's own rotation
  double moving_floor_m = 0.003;  ///< of any step that moves at all
  double moving_floor_rad = 0.002;

  void describe(FieldList& fields);

  /// Covariance of (x, y, theta) of one step, in the frame in which it started.
  Mat3 covariance(const Pose2& step) const;
};

/// Wheels that are read in every cycle, each reading with its own scan: an ordinary indoor vehicle's, even
/// three times as bad.
inline constexpr MotionNoise kReadEveryCycle{.distance_m_per_sqrt_m = 0.015,
                                             .distance_scale = 0.02,
                                             .rotation_rad_per_sqrt_m = 0.02,
                                             .rotation_rad_per_sqrt_rad = 0.01,
                                             .rotation_share = 0.05,
                                             .moving_floor_m = 0.0005,
                                             .moving_floor_rad = 0.0005};

}  // namespace aisle
