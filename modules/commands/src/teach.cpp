#include "aisle/commands/teach.hpp"

#include <fmt/format.h>

#include "aisle/commands/methods.hpp"
#include "aisle/commands/shipped_files.hpp"
#include "aisle/formats/worlds/vehicle_yaml.hpp"
#include "aisle/formats/worlds/world_yaml.hpp"
#include "aisle/guidance/rooms/room_cameras.hpp"
#include "aisle/missions/landmarks/landmark_run.hpp"
#include "aisle/missions/rooms/room_driver.hpp"
#include "aisle/missions/route_name.hpp"
#include "aisle/simulation/operators/route_guide.hpp"

namespace aisle {

namespace {

/// Only the first camera is learned from. A scripted person drives the world's route of that name.
Problems take_route(const TeachOptions& options, const VehicleDescription& vehicle, DriveOptions& drive) {
  if (Problems problems = unfit_for_rooms(vehicle, {kFirstCamera}); !problems.empty()) return problems;
  drive.camera = kFirstCamera;
  const auto file = shipped_or_own("worlds", drive.world);
  if (!file) return file.problems();
  const auto world = read_world(*file);
  if (!world) return world.problems();
  const WorldRoute* path = route_of(*world, options.route);
  if (path != nullptr) drive.T_world_start = start_of(*path);
  if (options.shows_view_pattern &&
      (drive.keys || path == nullptr || path->parking != ParkingStrategy::kView))
    return {{{"", 0, "--views"}, "only a scripted person can drive the pattern, around a taught place"}};
  if (drive.keys) return {};
  if (path == nullptr)
    return {{{file->string(), 0, "routes"},
             fmt::format("none is '{}', which a scripted person could drive; there are: {}", options.route,
                         names_of(world->routes))}};
  const ShownViews views = options.shows_view_pattern ? ShownViews::kPattern : ShownViews::kTrail;
  drive.keys = [world = *world, path = *path, seed = drive.seed, views](
                   const VehicleDescription& driven, const KeySpeeds&) -> Result<std::unique_ptr<Operator>> {
    return std::unique_ptr<Operator>(
        std::make_unique<RouteGuide>(world, path, driven, ScriptedOperatorParams{}, seed, views));
  };
  return {};
}

}  // namespace

Result<Outcome> run_teach(const TeachOptions& options, Console& console) {
  if (Problems problems = check_method(options.method); !problems.empty()) return problems;
  if (Problems problems = check_route_name({"", 0, "--route"}, options.route); !problems.empty())
    return problems;
  if (options.shows_view_pattern && options.method != "route")
    return Problem{{"", 0, "--views"}, "the pattern needs --method route"};
  DriveOptions drive = options.drive;
  drive.vehicle = vehicle_or_usual(drive.vehicle, options.method);
  const auto vehicle = read_shipped_or_own("vehicles", drive.vehicle, read_vehicle);
  if (!vehicle) return vehicle.problems();
  if (vehicle->description.cameras.empty())
    return Problem{{drive.vehicle, 0, "cameras"}, "there is none: nothing can be learned"};
  drive.route = options.route;
  if (options.method == "route") {
    if (Problems problems = take_route(options, vehicle->description, drive); !problems.empty())
      return problems;
  } else {
    drive.camera = corridor_camera(vehicle->description).name;
  }
  auto outcome = run_drive(drive, console);
  if (!outcome) return outcome.problems();
  outcome->verb = "teach";
  outcome->figures["route"] = options.route;
  return outcome;
}

}  // namespace aisle
