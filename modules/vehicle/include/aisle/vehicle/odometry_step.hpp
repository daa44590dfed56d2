#pragma once

#include "aisle/geometry/pose2.hpp"
#include "aisle/vehicle/observation.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// base_link after what the wheels counted, seen from base_link before.
Pose2 odometry_step(const VehicleDescription& vehicle, const OdometryReading& reading);

/// How the front wheels stood, left positive; 0 for a vehicle that has none to steer.
double steering_rad_of(const OdometryReading& reading);

}  // namespace aisle
