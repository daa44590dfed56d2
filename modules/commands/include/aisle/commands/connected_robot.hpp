#pragma once

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "aisle/commands/outcome.hpp"
#include "aisle/connection/connected_vehicle.hpp"
#include "aisle/connection/robot_diagnostics.hpp"
#include "aisle/connection/robot_viewer.hpp"
#include "aisle/core/clock.hpp"
#include "aisle/wire/wire.hpp"

namespace aisle {

/// A robot, and what it is reached by.
struct ConnectedRobot {
  SteadyClock clock;
  Connection connection;
  std::unique_ptr<Wire> wire;
  std::unique_ptr<RobotDiagnostics> diagnostics;
  std::unique_ptr<ConnectedVehicle> vehicle;
  std::unique_ptr<RobotViewer> viewer;  ///< last: each uses what stands before it
};

/// The sensors by which a mission drives. Nothing else is listened to, and each ends the mission's cycles.
enum class DrivenBy { kScanner, kCameras };

/// Connects to the robot of a connection file. Holding and going on are said as warnings.
Result<std::unique_ptr<ConnectedRobot>> connect_robot(const std::filesystem::path& connection_file,
                                                      DrivenBy sensors, Console& console);

/// The part of a connection that a mission uses: its sensors, and no joystick.
/// @return problems if there are no such sensors
Result<Connection> reduced_to(DrivenBy sensors, Connection connection);

/// The same with a connection that has been read.
Result<std::unique_ptr<ConnectedRobot>> connect_robot(Connection connection, Console& console);

/// The part of the network that a connection names.
WireSettings wire_settings(const ConnectedNetwork& network);

/// The vehicle file that a connection names: beside it, or a shipped one.
Result<VehicleDescription> vehicle_of(const Connection& connection);

nlohmann::ordered_json counts_json(const ConnectionCounts& counts);

}  // namespace aisle
