#include <fmt/format.h>

#include <algorithm>

#include "aisle/commands/learned_files.hpp"
#include "aisle/commands/method.hpp"
#include "aisle/commands/set_down.hpp"
#include "aisle/core/clock.hpp"
#include "aisle/core/rounded.hpp"
#include "aisle/evaluation/sections/section_evaluation.hpp"
#include "aisle/formats/buildings/building_json.hpp"
#include "aisle/formats/whole_file.hpp"
#include "aisle/missions/changed_parameters.hpp"
#include "aisle/missions/landmarks/landmark_run.hpp"
#include "aisle/missions/route_name.hpp"
#include "aisle/simulation/vehicle/simulated_vehicle.hpp"
#include "sections/section_verbs.hpp"

namespace aisle {
namespace {

/// How the map lies in the world near a pose on it: by the truth that learning wrote beside the building,
/// else its origin is the world's start.
Result<Pose2> map_about(const Pose2& T_map_place, const NavigateOptions& options,
                        const SimulationSetting& setting) {
  const auto truth = read_map_truth(options.building);
  if (!truth) return truth.problems();
  if (!truth->empty())
    return truth->in_world(T_map_place, truth->start(options.in_reverse)) * T_map_place.inverse();
  return start_in(setting);
}

std::string section_mission_text(const JudgedSectionMission& judged, bool and_back) {
  std::string text = mission_text(judged.mission) + "\n";
  if (!judged.errors) return text;
  const SectionErrors& errors = *judged.errors;
  text += fmt::format("ended {:.1f} cm and {:.2f} deg from where it {}\n", 100 * errors.closing_m,
                      to_degrees(errors.closing_rad), and_back ? "began" : "should");
  if (errors.wall_distance_m.count() > 0) {
    text += fmt::format("kept its distance from the right base line within {:.1f} cm (rms)\n",
                        100 * errors.wall_distance_m.rms());
  }
  return text;
}

}  // namespace

Result<Outcome> navigate_by_sections(const NavigateOptions& options, const SectionDriverParams& params,
                                     Console& console) {
  const std::string file = options.building.string();
  const auto text = read_whole_file(options.building);
  if (!text) return text.problems();
  const auto building = parse_building(*text, file);
  if (!building) return building.problems();
  auto setting =
      read_setting(options.world, kSectionMethod.vehicle_or_usual(options.vehicle), options.scenario);
  if (!setting) return setting.problems();
  VehicleDescription& vehicle = setting->vehicle.description;
  SessionOrigin origin{.navigator = kSectionNavigator,
                       .parameters = changed_parameters(params),
                       .seed = options.seed,
                       .building = *text,
                       .route = route_name(*building, options.route),
                       .in_reverse = options.in_reverse};
  const auto navigator = make_section_navigator(origin, vehicle);
  if (!navigator) return at_file(navigator.problems(), file);
  vehicle.cameras = {CameraDescription(corridor_camera(vehicle))};
  const Pose2 T_map_start = (*navigator)->path().at(0).T_map_path;
  const auto T_world_map = map_about(T_map_start, options, *setting);
  if (!T_world_map) return T_world_map.problems();
  if (!fits(setting->world, vehicle.footprint, *T_world_map * T_map_start))
    return Problem{{file, 0, "routes"}, "the vehicle does not fit at the route's start in this world"};
  const Pose2 T_world_start = set_down_on_route(*setting, *T_world_map * T_map_start, options.seed);
  SimulatedVehicle driven = vehicle_in(*setting, T_world_start, options.seed);
  auto session =
      open_session(options.out, options.force, options.storage, driven, &driven, origin, console.watcher);
  if (!session) return session.problems();
  const SteadyClock clock;
  const double begun_s = clock.now_s();
  auto mission = drive_section_mission(driven, &driven, **navigator, false, *session, console.progress);
  if (!mission) return mission.problems();
  if (const Problems problems = close_session(*session); !problems.empty()) return problems;
  const JudgedSectionMission result =
      judged(std::move(*mission), **navigator, {setting->world, *T_world_map, T_world_start});
  const MissionEnd& end = result.mission.end;
  Outcome outcome{.verb = "navigate", .ok = end.arrived && result.mission.is_unharmed()};
  outcome.figures = figures_of(result);
  outcome.figures["simulated"] = result.mission.is_simulated();
  outcome.figures["seed"] = options.seed;
  outcome.figures["route"] = origin.route;
  outcome.figures["in_reverse"] = options.in_reverse;
  outcome.figures["and_back"] = params.and_back;
  outcome.figures["real_time_factor"] = rounded(end.duration_s / std::max(clock.now_s() - begun_s, 1e-6), 1);
  if (!options.out.empty()) outcome.files["session"] = options.out.string();
  outcome.text = section_mission_text(result, params.and_back);
  return outcome;
}

}  // namespace aisle
