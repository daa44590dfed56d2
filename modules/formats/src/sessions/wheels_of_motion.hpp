#pragma once

#include "aisle/geometry/pose2.hpp"
#include "aisle/vehicle/observation.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// What the wheels would have counted over a motion of base_link: heading and distance ahead are kept, what
/// the vehicle moved sideways is not. Undoes odometry_step() except for the rounding to whole motor steps.
OdometryReading wheels_of(const VehicleDescription& vehicle, const Pose2& motion);

}  // namespace aisle
