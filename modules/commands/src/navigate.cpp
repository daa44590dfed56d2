#include "aisle/commands/navigate.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "aisle/commands/parameter_listing.hpp"
#include "aisle/core/clock.hpp"
#include "aisle/formats/building_json.hpp"
#include "aisle/formats/whole_file.hpp"
#include "aisle/simulation/simulated_vehicle.hpp"
#include "landmark_mission.hpp"
#include "learned_files.hpp"
#include "methods.hpp"
#include "rounded.hpp"
#include "simulated_record.hpp"

namespace aisle {
namespace {

/// All that a mission is made of, read and checked.
struct Mission {
  LandmarkNavigatorParams params;
  SimulationSetting setting;
  std::string building_text;
  Building building;
  const Route* route = nullptr;
  Path path;
  MapTruth truth;
};

Result<const Route*> find_route(const Building& building, const std::string& file, const std::string& name) {
  if (building.routes.empty()) return Problem{{file, 0, "routes"}, "there is none"};
  if (name.empty()) return &building.routes.front();
  const auto found = std::find_if(building.routes.begin(), building.routes.end(),
                                  [&](const Route& route) { return route.name == name; });
  if (found != building.routes.end()) return &*found;
  std::string names;
  for (const Route& route : building.routes) names += (names.empty() ? "" : ", ") + route.name;
  return Problem{{file, 0, "--route"}, fmt::format("'{}' is unknown; there is: {}", name, names)};
}

/// The vehicle's other cameras stay switched off.
Problems keep_learned_camera(VehicleDescription& vehicle, const Building& building, const std::string& file) {
  if (!building.camera) return {{{file, 0, "camera"}, "is missing: the building has no landmarks"}};
  const auto found = std::find_if(vehicle.cameras.begin(), vehicle.cameras.end(),
                                  [&](const CameraDescription& camera) { return camera.name == building.camera->name; });
  if (found == vehicle.cameras.end()) {
    return {{{file, 0, "camera"},
             fmt::format("was learned with the camera {}, which the vehicle {} lacks", building.camera->name,
                         vehicle.name)}};
  }
  vehicle.cameras = {*found};
  return at_file(check_same_camera(*building.camera, *found), file);
}

Problems read_mission(const NavigateOptions& options, Mission& mission) {
  const std::string file = options.building.string();
  if (options.speed_mps) mission.params.speed.speed_mps = *options.speed_mps;
  FieldList fields = fields_of(mission.params);
  if (Problems problems = options.parameters.apply_to(fields); !problems.empty()) return problems;
  auto text = read_whole_file(options.building);
  if (!text) return text.problems();
  mission.building_text = std::move(*text);
  auto building = parse_building(mission.building_text, file);
  if (!building) return building.problems();
  mission.building = std::move(*building);
  const auto route = find_route(mission.building, file, options.route);
  if (!route) return route.problems();
  mission.route = *route;
  auto setting = read_setting(options.world, options.vehicle, options.scenario);
  if (!setting) return setting.problems();
  mission.setting = std::move(*setting);
  VehicleDescription& vehicle = mission.setting.vehicle.description;
  if (Problems problems = keep_learned_camera(vehicle, mission.building, file); !problems.empty()) return problems;
  mission.path = options.in_reverse ? way_back(mission.route->path, vehicle.footprint) : mission.route->path;
  auto truth = read_map_truth(options.building);
  if (!truth) return truth.problems();
  mission.truth = std::move(*truth);
  if (mission.truth.empty()) {
    const auto start = start_in(mission.setting);
    if (!start) return start.problems();
    mission.truth = MapTruth({mission.route->path.at(0).T_map_path}, {*start});
  }
  if (!fits(mission.setting.world, vehicle.footprint, mission.truth.in_world(mission.path.at(0).T_map_path)))
    return {{{file, 0, "routes"}, "the vehicle does not fit at the route's start in this world"}};
  return {};
}

Outcome outcome_of(const NavigateOptions& options, const Mission& mission, const LandmarkMissionResult& result,
                   double worked_s) {
  const MissionErrors& errors = result.errors;
  Outcome outcome{.verb = "navigate", .ok = result.end.arrived && result.collisions == 0};
  outcome.figures = figures_of(result);
  outcome.figures["simulated"] = true;
  outcome.figures["seed"] = options.seed;
  outcome.figures["route"] = mission.route->name;
  outcome.figures["in_reverse"] = options.in_reverse;
  outcome.figures["landmarks"] = mission.building.landmarks.size();
  outcome.figures["real_time_factor"] = rounded(result.end.duration_s / std::max(worked_s, 1e-6), 1);
  if (!options.out.empty()) outcome.files["session"] = options.out.string();
  outcome.text = fmt::format(
      "simulated: {}{}{}; {:.1f} m in {:.1f} s, {} collision{}, lost {} time{}\n"
      "knew where it was to {:.1f} cm across, {:.1f} cm along, {:.2f} deg (rms)\n"
      "kept to its path within {:.1f} cm (rms), {:.1f} cm (worst)\n",
      result.end.state, result.end.why.empty() ? "" : ": ", result.end.why, result.distance_m,
      result.end.duration_s, result.collisions, result.collisions == 1 ? "" : "s", result.lost_count,
      result.lost_count == 1 ? "" : "s", 100 * errors.across_m.rms(), 100 * errors.along_m.rms(),
      to_degrees(errors.heading_rad.rms()), 100 * errors.tracking_m.rms(), 100 * errors.tracking_m.worst());
  return outcome;
}

}  // namespace

Outcome navigate_parameters() {
  LandmarkNavigatorParams params;
  return parameter_listing("navigate", fields_of(params));
}

Result<Outcome> run_navigate(const NavigateOptions& options, Console& console) {
  if (Problems problems = check_method(options.method); !problems.empty()) return problems;
  Mission mission;
  if (Problems problems = read_mission(options, mission); !problems.empty()) return problems;
  std::optional<SessionRecord> session;
  if (!options.out.empty()) {
    auto created = SessionRecord::create(options.out, options.force, mission.setting.vehicle.description,
                                         landmark_origin(mission.params, mission.building_text,
                                                         mission.route->name, options.in_reverse, options.seed));
    if (!created) return created.problems();
    session = std::move(*created);
  }
  const SteadyClock clock;
  const double begun_s = clock.now_s();
  const auto result = drive_landmark_mission(mission.setting, mission.building, mission.path, mission.params,
                                             mission.truth, {.seed = options.seed}, session, console.progress);
  if (!result) return result.problems();
  if (const Problems problems = close(session); !problems.empty()) return problems;
  return outcome_of(options, mission, *result, clock.now_s() - begun_s);
}

}  // namespace aisle
