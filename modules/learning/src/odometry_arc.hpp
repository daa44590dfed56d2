#pragma once

#include "aisle/vehicle/arc.hpp"
#include "aisle/vehicle/observation.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// One motion as an arc, and the covariance of (length, turn) but for what is steadily wrong.
struct UncertainArc {
  Arc arc;
  Mat2 covariance = Mat2::Zero();
};

UncertainArc uncertain_arc(const VehicleDescription& vehicle, const OdometryReading& reading);

/// Standard deviations of what is steadily wrong with the odometry: path scale, turn scale, turn per metre
/// [1/m]. The true arc is length * (1 + path), turn * (1 + scale) + length * per_metre.
Vec3 steady_odometry_sigmas(const VehicleDescription& vehicle);

}  // namespace aisle
