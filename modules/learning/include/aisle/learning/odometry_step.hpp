#pragma once

#include "aisle/vehicle/observation.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// base_link after what the wheels counted, seen from base_link before.
Pose2 odometry_step(const VehicleDescription& vehicle, const OdometryReading& reading);

}  // namespace aisle
