#include "aisle/vehicle/odometry_step.hpp"

namespace aisle {

Pose2 odometry_step(const VehicleDescription& vehicle, const OdometryReading& reading) {
  if (const auto* motion = std::get_if<FrontSteeredMotion>(&reading))
    return drive(vehicle.front_steered, *motion);
  return drive(vehicle.differential, std::get<WheelSteps>(reading));
}

double steering_rad_of(const OdometryReading& reading) {
  const auto* motion = std::get_if<FrontSteeredMotion>(&reading);
  return motion == nullptr ? 0 : motion->steering_rad;
}

}  // namespace aisle
