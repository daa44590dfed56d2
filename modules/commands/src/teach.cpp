#include "aisle/commands/teach.hpp"

#include "aisle/commands/method.hpp"
#include "aisle/commands/shipped_files.hpp"
#include "aisle/formats/worlds/vehicle_yaml.hpp"
#include "aisle/missions/route_name.hpp"

namespace aisle {

Result<Outcome> run_teach(const TeachOptions& options, Console& console) {
  const auto found = method_named(options.method);
  if (!found) return found.problems();
  const Method& method = **found;
  if (Problems problems = check_route_name({"", 0, "--route"}, options.route); !problems.empty())
    return problems;
  if (options.shows_view_pattern && !method.learns_views)
    return Problem{{"", 0, "--views"}, "the pattern needs --method route"};
  DriveOptions drive = options.drive;
  drive.vehicle = method.vehicle_or_usual(drive.vehicle);
  const auto vehicle = read_shipped_or_own("vehicles", drive.vehicle, read_vehicle);
  if (!vehicle) return vehicle.problems();
  if (vehicle->description.cameras.empty())
    return Problem{{drive.vehicle, 0, "cameras"}, "there is none: nothing can be learned"};
  drive.route = options.route;
  if (Problems problems = method.prepare(options, vehicle->description, drive); !problems.empty())
    return problems;
  auto outcome = run_drive(drive, console);
  if (!outcome) return outcome.problems();
  outcome->verb = "teach";
  outcome->figures["route"] = options.route;
  return outcome;
}

}  // namespace aisle
