#include <fmt/format.h>

#include <memory>

#include "aisle/commands/method.hpp"
#include "aisle/commands/shipped_files.hpp"
#include "aisle/formats/worlds/world_yaml.hpp"
#include "aisle/guidance/rooms/room_cameras.hpp"
#include "aisle/missions/route_name.hpp"
#include "aisle/simulation/operators/route_guide.hpp"
#include "rooms/room_verbs.hpp"

namespace aisle {
namespace {

/// Only the first camera is learned from. A scripted person drives the world's route of that name.
Problems prepare_for_rooms(const TeachOptions& options, const VehicleDescription& vehicle,
                           DriveOptions& drive) {
  const auto unfit = [](const VehicleDescription& driven) { return unfit_for_rooms(driven, {kFirstCamera}); };
  drive.camera = kFirstCamera;
  if (!drive.connection.empty()) {
    drive.unfit = unfit;  // only the connected robot says how its camera looks
    if (!options.shows_view_pattern) return {};
    return {{{"", 0, "--views"}, "only a scripted person can drive the pattern, which is simulated"}};
  }
  if (Problems problems = unfit(vehicle); !problems.empty())
    return at_file(std::move(problems), drive.vehicle_file());
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

const Method kRoomMethod = {
    .name = "rooms",
    .usual_vehicle = "alv",
    .learns_from_several = false,
    .learns_views = true,
    .prepare = prepare_for_rooms,
    .learn = [](const LearnOptions& options, const LearnParams& params,
                Console& console) { return learn_by_route(options, params.rooms, console); },
    .navigate = [](const NavigateOptions& options, const NavigateParams& params,
                   Console& console) { return navigate_by_route(options, params.rooms, console); }};

}  // namespace aisle
