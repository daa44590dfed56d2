#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "aisle/commands/driven_vehicle.hpp"
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
  std::unique_ptr<DrivenVehicle> driven;
  SessionOrigin origin;
  std::unique_ptr<LandmarkDriver> driver;
  MapTruth truth;  ///< of a simulated vehicle
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

/// Sets a simulated vehicle down at the route's start; a robot stands there.
Problems set_down_at_start(const NavigateOptions& options, const std::string& camera,
                           LandmarkNavigation& mission) {
  SimulationSetting* const setting = mission.driven->setting();
  if (setting == nullptr) return {};
  VehicleDescription& vehicle = setting->vehicle.description;
  std::erase_if(vehicle.cameras, [&](const CameraDescription& seen) { return seen.name != camera; });
  auto truth = map_truth(options, *setting);
  if (!truth) return truth.problems();
  mission.truth = std::move(*truth);
  const Pose2 T_world_start = mission.truth.in_world(mission.driver->path().at(0).T_map_path,
                                                     mission.truth.start(options.in_reverse));
  if (!fits(setting->world, vehicle.footprint, T_world_start))
    return {{{options.building.string(), 0, "routes"},
             "the vehicle does not fit at the route's start in this world"}};
  mission.driven->set_down(set_down_for_landmarks(*setting, T_world_start, options.seed));
  return {};
}

Result<LandmarkNavigation> read_navigation(const NavigateOptions& options,
                                           const LandmarkNavigatorParams& params, Console& console) {
  const std::string file = options.building.string();
  const auto text = read_whole_file(options.building);
  if (!text) return text.problems();
  const auto building = parse_building(*text, file);
  if (!building) return building.problems();
  auto driven = DrivenVehicle::open(vehicle_choice(options, kLandmarkMethod), DrivenBy::kCameras, console);
  if (!driven) return driven.problems();
  LandmarkNavigation mission{.driven = std::move(*driven), .origin = {}, .driver = {}, .truth = {}};
  mission.origin =
      LandmarkDriver::origin(params, {*text, route_name(*building, options.route), options.in_reverse});
  mission.origin.seed = options.seed;
  auto driver = LandmarkDriver::make(mission.origin, mission.driven->description());
  if (!driver) return at_file(driver.problems(), file);
  mission.driver = std::move(*driver);
  if (Problems problems = set_down_at_start(options, building->camera->name, mission); !problems.empty())
    return problems;
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
  mission.driven->add_to(outcome.figures);
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
  const auto mission = read_navigation(options, params, console);
  if (!mission) return mission.problems();
  DrivenVehicle& driven = *mission->driven;
  auto session = open_session(options.out, options.force, options.storage, driven.vehicle(), driven.truth(),
                              mission->origin, driven.watcher(console));
  if (!session) return session.problems();
  const SteadyClock clock;
  const double begun_s = clock.now_s();
  auto ended =
      drive_landmark_mission(driven.vehicle(), driven.truth(), *mission->driver, *session, console.progress);
  if (!ended) return ended.problems();
  if (const Problems problems = close_session(*session); !problems.empty()) return problems;
  const JudgedLandmarkMission result =
      judged(std::move(*ended), mission->truth, mission->driver->path(), options.in_reverse);
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
