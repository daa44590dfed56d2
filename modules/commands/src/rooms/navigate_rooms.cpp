#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "aisle/commands/driven_vehicle.hpp"
#include "aisle/commands/learned_files.hpp"
#include "aisle/commands/method.hpp"
#include "aisle/commands/parameter_listing.hpp"
#include "aisle/commands/park.hpp"
#include "aisle/evaluation/rooms/room_evaluation.hpp"
#include "aisle/evaluation/rooms/route_in_world.hpp"
#include "aisle/formats/buildings/building_json.hpp"
#include "aisle/formats/whole_file.hpp"
#include "aisle/guidance/rooms/room_cameras.hpp"
#include "aisle/missions/changed_parameters.hpp"
#include "rooms/room_verbs.hpp"

namespace aisle {
namespace {

/// The options of both verbs.
struct RoomDrive {
  std::filesystem::path building;
  std::string route;
  VehicleChoice vehicle;
  std::optional<ParkingStrategy> parking;  ///< strategy that the route must end with
  std::optional<Pose2> T_world_start;
  std::optional<double> from_end_m;  ///< initial pose so far before the route's end; none: at its start
  std::filesystem::path out;
  bool force = false;
  SessionStorage storage = SessionStorage::kSqlite;
};

/// Where a simulated vehicle is due to end.
struct RoomPlace {
  const World& world;
  Pose2 T_world_due;
};

/// How a route lies in the world: by the truth that learning wrote beside the building, else the route begins
/// at the world's start.
Result<RouteInWorld> route_in_world(const std::filesystem::path& building, const Route& route,
                                    const SimulationSetting& setting) {
  auto truth = read_map_truth(building);
  if (!truth) return truth.problems();
  if (!truth->empty()) return RouteInWorld(std::move(*truth), route);
  const auto start = start_in(setting);
  if (!start) return start.problems();
  return RouteInWorld(MapTruth({route.path.at(0).T_map_path}, {*start}), route);
}

std::string misreported(const OdometryCorrection& error) {
  return fmt::format(
      "by the images the vehicle drove {:.2f} times the path that its wheels counted, and its front wheels "
      "pointed {:.1f} degrees farther left than reported; it was driven by the images: check its odometry",
      error.distance_factor, to_degrees(error.steering_bias_rad));
}

Outcome room_outcome(const std::string& verb, const RoomDrive& drive, const Route& route,
                     const JudgedRoomMission& judged) {
  const RoomMissionResult& result = judged.mission;
  Outcome outcome{.verb = verb, .ok = result.parked()};
  outcome.figures = figures_of(judged);
  outcome.figures["route"] = route.name;
  if (!drive.out.empty()) outcome.files["session"] = drive.out.string();
  outcome.text = mission_text(result) + "\n";
  if (judged.errors)
    outcome.text +=
        fmt::format("end error {:.1f} cm and {:.2f} deg, {:.2f} m free ahead\n", 100 * judged.errors->end_m,
                    to_degrees(judged.errors->end_rad), judged.errors->clearance_m);
  return outcome;
}

/// Sets a simulated vehicle down on its route; a robot stands where it stands, and has no place in a world.
Result<std::optional<RoomPlace>> set_down_on_its_route(const RoomDrive& drive, const Route& route,
                                                       RoomDriverParams& params, DrivenVehicle& driven) {
  SimulationSetting* const setting = driven.setting();
  if (drive.from_end_m) params.from_m = std::max(0.0, route.path.length_m() - *drive.from_end_m);
  if (setting == nullptr) return std::optional<RoomPlace>();
  const auto place = route_in_world(drive.building, route, *setting);
  if (!place) return place.problems();
  if (drive.T_world_start) params.from_m = place->along_m(*drive.T_world_start);
  const Pose2 T_world_start = drive.T_world_start.value_or(place->at(params.from_m));
  VehicleDescription& vehicle = setting->vehicle.description;
  if (!fits(setting->world, vehicle.footprint, T_world_start))
    return Problem{{drive.building.string(), 0, "routes"},
                   "the vehicle does not fit at its start in this world"};
  if (vehicle.cameras.size() > 1 && unfit_for_rooms(vehicle, cameras_for(route)).empty())
    keep_cameras(vehicle, cameras_for(route));
  driven.set_down(T_world_start);
  return std::optional(
      RoomPlace{setting->world, due_end(setting->world, vehicle.footprint, route.room->parking, place->end(),
                                        params.navigator.frame_backing.wanted)});
}

Result<Outcome> drive_room(const std::string& verb, const RoomDrive& drive, RoomDriverParams params,
                           Console& console) {
  const std::string file = drive.building.string();
  const auto text = read_whole_file(drive.building);
  if (!text) return text.problems();
  const auto building = parse_building(*text, file);
  if (!building) return building.problems();
  const auto route = find_room_route(*building, drive.route);
  if (!route) return at_file(route.problems(), file);
  if (drive.parking && *drive.parking != route->room->parking)
    return Problem{{"--strategy"},
                   fmt::format("the route '{}' was taught with another parking strategy", route->name)};
  if (params.navigator.frame_backing.wanted && route->room->parking != ParkingStrategy::kFrame)
    return Problem{{"--reverse"}, fmt::format("the route '{}' does not end in a painted frame", route->name)};
  const auto opened = DrivenVehicle::open(drive.vehicle, DrivenBy::kCameras, console);
  if (!opened) return opened.problems();
  DrivenVehicle& driven = **opened;
  const auto place = set_down_on_its_route(drive, *route, params, driven);
  if (!place) return place.problems();
  const SessionOrigin origin{.navigator = kRoomNavigator,
                             .parameters = changed_parameters(params),
                             .seed = drive.vehicle.seed,
                             .building = *text,
                             .route = route->name};
  const auto navigator = make_room_navigator(origin, driven.description());
  if (!navigator) return at_file(navigator.problems(), file);
  auto session = open_session(drive.out, drive.force, drive.storage, driven.vehicle(), driven.truth(), origin,
                              driven.watcher(console));
  if (!session) return session.problems();
  auto mission =
      drive_room_mission(driven.vehicle(), driven.truth(), **navigator, *session, console.progress);
  if (!mission) return mission.problems();
  if (mission->odometry_correction) console.warn(misreported(*mission->odometry_correction));
  if (const Problems problems = close_session(*session); !problems.empty()) return problems;
  const JudgedRoomMission result = *place ? judged(std::move(*mission), (*place)->world,
                                                   driven.description().footprint, (*place)->T_world_due)
                                          : JudgedRoomMission{std::move(*mission), std::nullopt};
  Outcome outcome = room_outcome(verb, drive, *route, result);
  driven.add_to(outcome.figures);
  return outcome;
}

}  // namespace

Result<Outcome> navigate_by_route(const NavigateOptions& options, const RoomDriverParams& params,
                                  Console& console) {
  if (options.in_reverse || options.and_back)
    return Problem{{"--method"},
                   "routes through rooms can only be driven in the direction in which they were taught"};
  return drive_room("navigate",
                    {.building = options.building,
                     .route = options.route,
                     .vehicle = vehicle_choice(options, kRoomMethod),
                     .parking = {},
                     .T_world_start = {},
                     .from_end_m = {},
                     .out = options.out,
                     .force = options.force,
                     .storage = options.storage},
                    params, console);
}

Outcome park_parameters() {
  RoomDriverParams params;
  return parameter_listing("park", fields_of(params));
}

Result<Outcome> run_park(const ParkOptions& options, Console& console) {
  constexpr double kUsualStart_m = 3;
  RoomDriverParams params;
  FieldList fields = fields_of(params);
  if (Problems problems = options.parameters.apply_to(fields); !problems.empty()) return problems;
  params.navigator.frame_backing.wanted |= options.in_reverse;
  return drive_room("park",
                    {.building = options.building,
                     .route = options.place,
                     .vehicle = {.connection = options.connection,
                                 .world = options.world,
                                 .vehicle = kRoomMethod.vehicle_or_usual(options.vehicle),
                                 .scenario = options.scenario,
                                 .seed = options.seed},
                     .parking = options.strategy,
                     .T_world_start = options.T_world_start,
                     .from_end_m = kUsualStart_m,
                     .out = options.out,
                     .force = options.force,
                     .storage = options.storage},
                    params, console);
}

}  // namespace aisle
