#pragma once

#include "aisle/geometry/pose2.hpp"
#include "aisle/vehicle/observation.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// Wheels that count in steps so fine that rounding to them does not matter.
void make_steps_fine(Differential& differential);

/// Poses of the odometry as what wheels count. What a reading cannot say, by rounding to whole steps or by a
/// path that is no arc, is in the next one.
class OdometryReadings {
 public:
  /// `vehicle` must outlive the readings.
  OdometryReadings(const VehicleDescription& vehicle, const Pose2& T_odom_start)
      : vehicle_(vehicle), T_odom_read_(T_odom_start) {}

  /// @param steering_rad  of front wheels that stand
  OdometryReading read(const Pose2& T_odom_vehicle, double steering_rad);

 private:
  const VehicleDescription& vehicle_;
  Pose2 T_odom_read_;  ///< where the readings so far lead
};

}  // namespace aisle
