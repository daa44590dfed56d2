#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "aisle/commands/learned_files.hpp"
#include "aisle/commands/method.hpp"
#include "aisle/commands/set_down.hpp"
#include "aisle/core/clock.hpp"
#include "aisle/core/rounded.hpp"
#include "aisle/evaluation/landmarks/landmark_evaluation.hpp"
#include "aisle/formats/buildings/building_json.hpp"
#include "aisle/formats/sessions/session_writer.hpp"
#include "aisle/formats/whole_file.hpp"
#include "aisle/missions/route_name.hpp"
#include "landmarks/landmark_verbs.hpp"

namespace aisle {
namespace {

/// Everything a mission needs, read and checked.
struct LandmarkNavigation {
  SimulationSetting setting;
  SessionOrigin origin;
  std::unique_ptr<LandmarkDriver> driver;
  MapTruth truth;
};

/// How the map lies in the world: by the truth that learning wrote beside the building, else the route begins
/// at the world's start.
Result<MapTruth> map_truth(const NavigateOptions& options, const SimulationSetting& setting) {
  auto truth = read_map_truth(options.building);
  if (!truth || !truth->empty()) return truth;
  const auto start = start_in(setting);
  if (!start) return start.problems();
  return MapTruth({Pose2{}}, {*start});
}

Pose2 route_start_in_world(const LandmarkNavigation& mission, bool in_reverse) {
  return mission.truth.in_world(mission.driver->path().at(0).T_map_path, mission.truth.start(in_reverse));
}

Result<LandmarkNavigation> read_navigation(const NavigateOptions& options,
                                           const LandmarkNavigatorParams& params) {
  const std::string file = options.building.string();
  const auto text = read_whole_file(options.building);
  if (!text) return text.problems();
  const auto building = parse_building(*text, file);
  if (!building) return building.problems();
  auto setting =
      read_setting(options.world, kLandmarkMethod.vehicle_or_usual(options.vehicle), options.scenario);
  if (!setting) return setting.problems();
  LandmarkNavigation mission{.setting = std::move(*setting), .origin = {}, .driver = {}, .truth = {}};
  VehicleDescription& vehicle = mission.setting.vehicle.description;
  mission.origin =
      LandmarkDriver::origin(params, {*text, route_name(*building, options.route), options.in_reverse});
  mission.origin.seed = options.seed;
  auto driver = LandmarkDriver::make(mission.origin, vehicle);
  if (!driver) return at_file(driver.problems(), file);
  mission.driver = std::move(*driver);
  std::erase_if(vehicle.cameras,
                [&](const CameraDescription& camera) { return camera.name != building->camera->name; });
  auto truth = map_truth(options, mission.setting);
  if (!truth) return truth.problems();
  mission.truth = std::move(*truth);
  if (!fits(mission.setting.world, vehicle.footprint, route_start_in_world(mission, options.in_reverse)))
    return Problem{{file, 0, "routes"}, "the vehicle does not fit at the route's start in this world"};
  return mission;
}

std::string errors_text(const MissionErrors& errors) {
  return fmt::format(
      "pose error {:.1f} cm across, {:.1f} cm along, {:.2f} deg (rms)\n"
      "cross-track error {:.1f} cm (rms), {:.1f} cm (worst)\n",
      100 * errors.across_m.rms(), 100 * errors.along_m.rms(), to_degrees(errors.heading_rad.rms()),
      100 * errors.tracking_m.rms(), 100 * errors.tracking_m.worst());
}

Outcome landmark_navigation_outcome(const NavigateOptions& options, const LandmarkNavigation& mission,
                                    const JudgedLandmarkMission& judged, double worked_s) {
  const LandmarkMissionResult& result = judged.mission;
  Outcome outcome{.verb = "navigate", .ok = result.end.arrived && result.is_unharmed()};
  outcome.figures = figures_of(judged);
  outcome.figures["simulated"] = result.is_simulated();
  outcome.figures["seed"] = options.seed;
  outcome.figures["route"] = mission.origin.route;
  outcome.figures["in_reverse"] = options.in_reverse;
  outcome.figures["landmarks"] = mission.driver->building().landmarks.size();
  outcome.figures["real_time_factor"] = rounded(result.end.duration_s / std::max(worked_s, 1e-6), 1);
  if (!options.out.empty()) outcome.files["session"] = options.out.string();
  outcome.text = fmt::format("{}, lost {} time{}\n", mission_text(result), result.lost_count,
                             result.lost_count == 1 ? "" : "s");
  if (judged.errors) outcome.text += errors_text(*judged.errors);
  return outcome;
}

}  // namespace

Result<Outcome> navigate_by_landmarks(const NavigateOptions& options, const LandmarkNavigatorParams& params,
                                      Console& console) {
  if (options.and_back)
    return Problem{{"--and-back"}, "is for --method sections; by landmarks the return path is --reverse"};
  const auto mission = read_navigation(options, params);
  if (!mission) return mission.problems();
  SimulatedVehicle vehicle =
      vehicle_in(mission->setting,
                 set_down_for_landmarks(mission->setting, route_start_in_world(*mission, options.in_reverse),
                                        options.seed),
                 options.seed);
  auto session = open_session(options.out, options.force, options.storage, vehicle, &vehicle, mission->origin,
                              console.watcher);
  if (!session) return session.problems();
  const SteadyClock clock;
  const double begun_s = clock.now_s();
  auto driven = drive_landmark_mission(vehicle, &vehicle, *mission->driver, *session, console.progress);
  if (!driven) return driven.problems();
  if (const Problems problems = close_session(*session); !problems.empty()) return problems;
  const JudgedLandmarkMission result =
      judged(std::move(*driven), mission->truth, mission->driver->path(), options.in_reverse);
  Outcome outcome = landmark_navigation_outcome(options, *mission, result, clock.now_s() - begun_s);
  if (options.out.empty()) return outcome;
  const std::filesystem::path image = options.out / kDrivenImage;
  if (Problems problems = write_whole_file(
          image, trace_picture(mission->driver->building(), result.mission,
                               result.mission.is_simulated() ? "driven alone, simulated" : "driven alone"));
      !problems.empty())
    return problems;
  outcome.files["driven_svg"] = image.string();
  return outcome;
}

}  // namespace aisle
