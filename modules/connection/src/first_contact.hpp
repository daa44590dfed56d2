#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "aisle/connection/connected_vehicle.hpp"
#include "aisle/connection/seen_camera.hpp"
#include "command_messages.hpp"
#include "robot_intake.hpp"
#include "scan_fitting.hpp"

namespace aisle {

/// So many periods must be known before a sensor's median period is.
inline constexpr std::size_t kPeriodsNeeded = 3;

/// What must be known of a robot before it can be driven.
struct FirstContact {
  VehicleDescription vehicle;  ///< as it is driven; a scan ends its cycles if it has a scanner, else an image
  BeamGrid grid;
  bool is_upside_down = false;               ///< the scanner
  std::vector<SeenCamera> cameras;           ///< as in the connection
  std::optional<CommandKind> commands = {};  ///< none: aisle sends nothing
};

/// Waits until a robot has said what must be known of it, up to 10 s.
Result<FirstContact> make_contact(const Connection& connection, const VehicleDescription& vehicle,
                                  RobotIntake& intake, const ConnectedVehicle::Surroundings& surroundings);

}  // namespace aisle
