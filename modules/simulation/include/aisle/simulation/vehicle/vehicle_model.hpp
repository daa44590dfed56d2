#pragma once

#include <map>
#include <string>

#include "aisle/simulation/vehicle/camera_sensor.hpp"
#include "aisle/simulation/vehicle/range_scanner.hpp"
#include "aisle/simulation/vehicle/wheel_odometry.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// How a vehicle's parts really are, which only the simulator knows.
struct SimulatedParts {
  WheelErrors odometry;
  std::map<std::string, CameraSensorParams> cameras;  ///< by name; a camera that is absent has the defaults
  RangeSensorParams scanner;
};

/// A vehicle to simulate: what it knows of itself, and how it really is.
struct VehicleModel {
  VehicleDescription description;
  SimulatedParts simulated;
};

}  // namespace aisle
