#pragma once

#include "aisle/vehicle/arc.hpp"
#include "aisle/vehicle/observation.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// One motion as an arc, and the covariance of (length, turn) without systematic errors.
struct UncertainArc {
  Arc arc;
  Mat2 covariance = Mat2::Zero();
};

UncertainArc uncertain_arc(const VehicleDescription& vehicle, const OdometryReading& reading);

/// Standard deviations of the systematic odometry errors: distance scale, turn scale, turn per metre [1/m].
/// The true arc is length * (1 + distance scale), turn * (1 + turn scale) + length * per_metre.
Vec3 steady_odometry_sigmas(const VehicleDescription& vehicle);

}  // namespace aisle
