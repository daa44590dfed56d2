#include "aisle/commands/teach.hpp"

#include <utility>

#include "aisle/commands/connected_robot.hpp"
#include "aisle/commands/method.hpp"
#include "aisle/commands/shipped_files.hpp"
#include "aisle/formats/worlds/vehicle_yaml.hpp"
#include "aisle/missions/route_name.hpp"

namespace aisle {
namespace {

/// Of a robot, what is known before it is connected: its drive, and the names of its cameras.
Result<VehicleDescription> taught_vehicle(const DriveOptions& drive) {
  if (drive.connection.empty()) {
    auto model = read_shipped_or_own("vehicles", drive.vehicle, read_vehicle);
    if (!model) return model.problems();
    return std::move(model->description);
  }
  const auto connection = read_connection(drive.connection);
  if (!connection) return connection.problems();
  auto vehicle = vehicle_of(*connection);
  if (!vehicle) return vehicle;
  vehicle->cameras.clear();
  for (const ConnectedCamera& camera : connection->cameras)
    vehicle->cameras.emplace_back().name = camera.name;
  return vehicle;
}

}  // namespace

Result<Outcome> run_teach(const TeachOptions& options, Console& console) {
  const auto found = method_named(options.method, console);
  if (!found) return found.problems();
  const Method& method = **found;
  if (Problems problems = check_route_name({"", 0, "--route"}, options.route); !problems.empty())
    return problems;
  if (options.shows_view_pattern && !method.learns_views)
    return Problem{{"", 0, "--views"}, "the pattern needs --method rooms"};
  DriveOptions drive = options.drive;
  drive.vehicle = method.vehicle_or_usual(drive.vehicle);
  const auto vehicle = taught_vehicle(drive);
  if (!vehicle) return vehicle.problems();
  if (vehicle->cameras.empty())
    return Problem{{drive.vehicle_file(), 0, "cameras"}, "there is none: nothing can be learned"};
  drive.route = options.route;
  if (Problems problems = method.prepare(options, *vehicle, drive); !problems.empty()) return problems;
  auto outcome = run_drive(drive, console);
  if (!outcome) return outcome.problems();
  outcome->verb = "teach";
  outcome->figures["route"] = options.route;
  return outcome;
}

}  // namespace aisle
