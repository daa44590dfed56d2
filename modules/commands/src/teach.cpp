#include "aisle/commands/teach.hpp"

#include <fmt/format.h>

#include "aisle/commands/shipped_files.hpp"
#include "aisle/formats/vehicle_yaml.hpp"
#include "landmark_trip.hpp"
#include "methods.hpp"
#include "route_name.hpp"

namespace aisle {

Result<Outcome> run_teach(const TeachOptions& options, Console& console) {
  if (Problems problems = check_method(options.method); !problems.empty()) return problems;
  if (Problems problems = check_route_name({"", 0, "--route"}, options.route); !problems.empty())
    return problems;
  DriveOptions drive = options.drive;
  drive.vehicle = vehicle_or_usual(drive.vehicle, options.method);
  const auto vehicle = read_vehicle(shipped_or_own("vehicles", drive.vehicle));
  if (!vehicle) return vehicle.problems();
  if (vehicle->description.cameras.empty())
    return Problem{{drive.vehicle, 0, "cameras"}, "there is none: nothing can be learned"};
  drive.camera = corridor_camera(vehicle->description).name;
  drive.route = options.route;
  auto outcome = run_drive(drive, console);
  if (!outcome) return outcome.problems();
  outcome->verb = "teach";
  outcome->figures["route"] = options.route;
  return outcome;
}

}  // namespace aisle
