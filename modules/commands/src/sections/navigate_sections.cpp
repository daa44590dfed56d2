#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "aisle/commands/driven_vehicle.hpp"
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

/// Sets a simulated vehicle down at the route's start; a robot stands there, and has no place in a world.
Result<std::optional<SectionPlace>> set_down_at_start(const NavigateOptions& options,
                                                      const Pose2& T_map_start, DrivenVehicle& driven) {
  SimulationSetting* const setting = driven.setting();
  if (setting == nullptr) return std::optional<SectionPlace>();
  VehicleDescription& vehicle = setting->vehicle.description;
  vehicle.cameras = {CameraDescription(corridor_camera(vehicle))};
  const auto T_world_map = map_about(T_map_start, options, *setting);
  if (!T_world_map) return T_world_map.problems();
  if (!fits(setting->world, vehicle.footprint, *T_world_map * T_map_start))
    return Problem{{options.building.string(), 0, "routes"},
                   "the vehicle does not fit at the route's start in this world"};
  const Pose2 T_world_start = set_down_on_route(*setting, *T_world_map * T_map_start, options.seed);
  driven.set_down(T_world_start);
  return std::optional(SectionPlace{setting->world, *T_world_map, T_world_start});
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
  const auto opened =
      DrivenVehicle::open(vehicle_choice(options, kSectionMethod), DrivenBy::kCameras, console);
  if (!opened) return opened.problems();
  DrivenVehicle& driven = **opened;
  SessionOrigin origin{.navigator = kSectionNavigator,
                       .parameters = changed_parameters(params),
                       .seed = options.seed,
                       .building = *text,
                       .route = route_name(*building, options.route),
                       .in_reverse = options.in_reverse};
  const auto navigator = make_section_navigator(origin, driven.description());
  if (!navigator) return at_file(navigator.problems(), file);
  const auto place = set_down_at_start(options, (*navigator)->path().at(0).T_map_path, driven);
  if (!place) return place.problems();
  auto session = open_session(options.out, options.force, options.storage, driven.vehicle(), driven.truth(),
                              origin, driven.watcher(console));
  if (!session) return session.problems();
  const SteadyClock clock;
  const double begun_s = clock.now_s();
  auto mission =
      drive_section_mission(driven.vehicle(), driven.truth(), **navigator, false, *session, console.progress);
  if (!mission) return mission.problems();
  if (const Problems problems = close_session(*session); !problems.empty()) return problems;
  const JudgedSectionMission result = *place ? judged(std::move(*mission), **navigator, **place)
                                             : JudgedSectionMission{std::move(*mission), std::nullopt};
  const MissionEnd& end = result.mission.end;
  Outcome outcome{.verb = "navigate", .ok = end.arrived && result.mission.is_unharmed()};
  outcome.figures = figures_of(result);
  driven.add_to(outcome.figures);
  outcome.figures["route"] = origin.route;
  outcome.figures["in_reverse"] = options.in_reverse;
  outcome.figures["and_back"] = params.and_back;
  outcome.figures["real_time_factor"] = rounded(end.duration_s / std::max(clock.now_s() - begun_s, 1e-6), 1);
  if (!options.out.empty()) outcome.files["session"] = options.out.string();
  outcome.text = section_mission_text(result, params.and_back);
  return outcome;
}

}  // namespace aisle
