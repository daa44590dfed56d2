#include "aisle/commands/connected_robot.hpp"

#include <utility>

#include "aisle/commands/shipped_files.hpp"
#include "aisle/core/rounded.hpp"
#include "aisle/formats/worlds/vehicle_yaml.hpp"

namespace aisle {

WireSettings wire_settings(const ConnectedNetwork& network) {
  return {.domain = static_cast<unsigned>(network.domain),
          .interface_address = network.interface_address,
          .peers = network.peers,
          .announces_by_multicast = network.multicast};
}

Result<VehicleDescription> vehicle_of(const Connection& connection) {
  const std::filesystem::path beside =
      std::filesystem::path(connection.file).parent_path() / connection.vehicle;
  std::error_code none;
  const bool is_file = std::filesystem::is_regular_file(beside, none);
  auto model = read_shipped_or_own(
      "vehicles", is_file ? std::filesystem::absolute(beside).string() : connection.vehicle, read_vehicle);
  if (!model) return model.problems();
  return std::move(model->description);
}

Result<Connection> reduced_to(DrivenBy sensors, Connection connection) {
  connection.joystick.topic.clear();
  const bool by_scanner = sensors == DrivenBy::kScanner;
  if (by_scanner) connection.cameras.clear();
  if (by_scanner && connection.scan.topic.empty())
    return Problem{{connection.file, 0, "scan.topic"}, "is empty, but this drives by a scanner"};
  if (!by_scanner) connection.scan.topic.clear();
  if (!by_scanner && connection.cameras.empty())
    return Problem{{connection.file, 0, "cameras"}, "there are none, but this drives by a camera"};
  return connection;
}

Result<std::unique_ptr<ConnectedRobot>> connect_robot(const std::filesystem::path& connection_file,
                                                      DrivenBy sensors, Console& console) {
  auto read = read_connection(connection_file);
  if (!read) return read.problems();
  auto connection = reduced_to(sensors, std::move(*read));
  if (!connection) return connection.problems();
  if (connection->commands.topic.empty())
    return Problem{{connection->file, 0, "command.topic"}, "is empty, but this sends commands"};
  return connect_robot(std::move(*connection), console);
}

Result<std::unique_ptr<ConnectedRobot>> connect_robot(Connection connection, Console& console) {
  const auto vehicle = vehicle_of(connection);
  if (!vehicle) return vehicle.problems();
  auto wire = Wire::open(wire_settings(connection.network));
  if (!wire) return wire.problems();
  auto robot = std::make_unique<ConnectedRobot>();
  robot->connection = std::move(connection);
  robot->wire = std::move(*wire);
  robot->diagnostics = std::make_unique<RobotDiagnostics>(*robot->wire, robot->clock, console.progress);
  RobotDiagnostics& diagnostics = *robot->diagnostics;
  const auto note = [&diagnostics, warn = console.warn](const std::string& what) {
    diagnostics.note(what);
    warn(what);
  };
  auto connected =
      ConnectedVehicle::connect(robot->connection, *vehicle, {*robot->wire, robot->clock, diagnostics, note});
  if (!connected) return connected.problems();
  robot->vehicle = std::move(*connected);
  diagnostics.watch(*robot->vehicle);
  robot->viewer = std::make_unique<RobotViewer>(*robot->wire, robot->connection, *robot->vehicle,
                                                console.watcher, console.warn);
  return robot;
}

nlohmann::ordered_json counts_json(const ConnectionCounts& counts) {
  return {{"messages", counts.messages},
          {"unreadable", counts.unreadable},
          {"scans_skipped", counts.scans_skipped},
          {"images_skipped", counts.images_skipped},
          {"scans_foreign", counts.scans_foreign},
          {"out_of_order", counts.out_of_order},
          {"clock_gaps", counts.clock_gaps},
          {"odometry_late", counts.odometry_late},
          {"odometry_leaps", counts.odometry_leaps},
          {"commands_aged", counts.commands_aged},
          {"holds", counts.holds},
          {"held_s", rounded(counts.held_s, 1)}};
}

}  // namespace aisle
