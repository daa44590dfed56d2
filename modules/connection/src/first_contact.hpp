#pragma once

#include <string>

#include "aisle/connection/connected_vehicle.hpp"
#include "command_messages.hpp"
#include "robot_intake.hpp"
#include "scan_fitting.hpp"

namespace aisle {

/// What must be known of a robot before it can be driven.
struct FirstContact {
  VehicleDescription vehicle;  ///< as it is driven
  BeamGrid grid;
  bool is_upside_down = false;  ///< the scanner
  CommandKind commands = CommandKind::kTwist;
};

/// Waits until a robot has said what must be known of it, up to 10 s.
Result<FirstContact> make_contact(const Connection& connection, const VehicleDescription& vehicle,
                                  RobotIntake& intake, const ConnectedVehicle::Surroundings& surroundings);

}  // namespace aisle
