#include "aisle/commands/explore.hpp"

#include <fmt/format.h>

#include <utility>

#include "aisle/commands/output_directory.hpp"
#include "aisle/commands/parameter_listing.hpp"
#include "aisle/formats/buildings/building_json.hpp"
#include "aisle/formats/sessions/session_cycles.hpp"
#include "aisle/formats/sessions/session_truth.hpp"
#include "aisle/learning/corridors/corridor_tracing.hpp"
#include "aisle/learning/walls/map_building.hpp"
#include "aisle/maps/grazing_walls.hpp"
#include "aisle/simulation/vehicle/simulated_vehicle.hpp"
#include "exploration/exploration_check.hpp"
#include "exploration/exploration_evaluation.hpp"
#include "exploration/exploration_mission.hpp"
#include "exploration/exploration_report.hpp"
#include "exploration/exploration_trial.hpp"
#include "exploration/explore_in.hpp"
#include "exploration/explorer_driver.hpp"
#include "exploration/exploring_start.hpp"
#include "plan_reading.hpp"
#include "rounded.hpp"
#include "simulated_record.hpp"
#include "statistics.hpp"

namespace aisle {
namespace {

/// Everything an exploration needs, read and checked.
struct ExplorationPlan {
  SimulationSetting setting;
  ExplorerNavigatorParams params;
  Pose2 T_world_start;
};

/// Removes all sensors that are not used to explore.
void keep_sensor(const ExploreOptions& options, VehicleDescription& vehicle) {
  const bool by_markers = options.sensor == ExploringSensor::kMarkers;
  if (by_markers) vehicle.scanner.reset();
  std::erase_if(vehicle.cameras, [&](const CameraDescription& camera) {
    return !by_markers || camera.name != options.camera;
  });
}

/// A camera's view is narrow: near a wall it shows only a short piece of it, and a door frame in that piece
/// turns it by degrees.
void suit_markers(SegmentParams& segments) {
  segments.length_min_m = 0.5;
  segments.uneven_m = 0.03;
}

Result<ExplorationPlan> read_plan(const ExploreOptions& options, SimulationSetting setting) {
  ExplorationPlan plan;
  if (options.sensor == ExploringSensor::kMarkers) suit_markers(plan.params.learner.mapping.segments);
  FieldList fields = fields_of(plan.params);
  if (Problems problems = options.parameters.apply_to(fields); !problems.empty()) return problems;
  plan.setting = std::move(setting);
  VehicleDescription& vehicle = plan.setting.vehicle.description;
  if (Problems problems = check_sensor(options.sensor, options.camera, vehicle); !problems.empty())
    return problems;
  keep_sensor(options, vehicle);
  if (options.T_world_start) {
    plan.T_world_start = *options.T_world_start;
  } else {
    const auto start = start_in(plan.setting);
    if (!start) return start.problems();
    plan.T_world_start = is_plan(plan.setting.world_file)
                             ? start_with_a_path(plan.setting.world, vehicle.footprint, *start)
                             : *start;
  }
  if (Problems problems =
          check_explorable(plan.setting.world, plan.setting.world_file.string(), vehicle, plan.T_world_start);
      !problems.empty())
    return problems;
  return plan;
}

struct Explored {
  ExplorationMissionResult mission;
  MapResult map;
  FloorGrid floor;
  CorridorGraph corridors;
  ExplorationScore truth;  ///< learned building against the ground truth
};

SensorField field_of(const LaserScanner& scanner, std::size_t beams, double reach_m, double height_m) {
  return {.T_vehicle_sensor = scanner.T_vehicle_laser,
          .reach_m = reach_m,
          .width_rad = scanner.angle_step_rad * static_cast<double>(beams - 1),
          .height_m = height_m};
}

Result<Explored> explore_once(const ExploreOptions& options, const ExplorationPlan& plan,
                              std::optional<InterruptedRun> former, std::optional<SessionRecord>& session,
                              Progress& progress) {
  const VehicleDescription& vehicle = plan.setting.vehicle.description;
  const auto explorer = make_explorer(explorer_origin(plan.params, options), vehicle);
  if (!explorer) return explorer.problems();
  ExplorerNavigator& navigator = **explorer;
  auto mission = drive_exploration(plan.setting, navigator, plan.T_world_start, options.seed,
                                   std::move(former), session, progress);
  if (!mission) return mission.problems();
  const LaserLog& log = mission->log;
  MapResult map = build_map(log, plan.params.learner.mapping, 0.0, false, progress);
  FloorGrid floor = navigator.learner().floor_from(map.T_map_vehicle);
  draw_grazing_walls(map.walls, floor);
  CorridorGraph corridors = trace_corridors(floor, map.T_map_vehicle.front().position(), {});
  const double height_m = vehicle.laser_markers ? vehicle.laser_markers->height_m
                                                : plan.setting.vehicle.simulated.scanner.height_m;
  const SensorField field =
      field_of(log.laser, log.scans.front().ranges_m.size(), plan.params.learner.view.reach_m, height_m);
  const ExplorationScore truth = evaluate_exploration(
      plan.setting.world, vehicle, field,
      {mission->T_world_scan, map_in_world(map.T_map_vehicle, mission->T_world_scan), floor, map.walls});
  return Explored{std::move(*mission), std::move(map), std::move(floor), std::move(corridors), truth};
}

bool has_certificate(const Explored& explored) {
  return explored.mission.record.certified() && explored.mission.collisions == 0 &&
         explored.truth.covered_share >= kCompleteShare;
}

nlohmann::ordered_json figures_of(const Explored& explored) {
  const ExplorationMissionResult& mission = explored.mission;
  const ExplorationScore& truth = explored.truth;
  return {{"simulated", true},
          {"covered_share", rounded(truth.covered_share, 4)},
          {"mapped_share", rounded(truth.mapped_share, 4)},
          {"came_home", mission.record.came_home},
          {"home_error_m", rounded(truth.home_error_m, 4)},
          {"home_error_deg", rounded(to_degrees(truth.home_error_rad), 3)},
          {"collisions", mission.collisions},
          {"distance_m", rounded(mission.distance_m, 3)},
          {"duration_s", rounded(mission.end.duration_s, 1)},
          {"graph_bound_m", rounded(truth.graph_bound_m, 3)},
          {"crossings", explored.corridors.count(CorridorNode::Kind::kCrossing)},
          {"dead_ends", explored.corridors.count(CorridorNode::Kind::kEnd)},
          {"wall_rmse_m", rounded(truth.walls.rmse_m, 4)},
          {"wall_missed_share", rounded(truth.walls.missed_share(), 4)},
          {"wall_false_share", rounded(truth.walls.false_share(), 4)},
          {"free_m2", rounded(explored.floor.free_m2(), 2)},
          {"certificate", has_certificate(explored)},
          {"ended_because", mission.record.ended_because},
          {"loop_closures", explored.map.loop_closures.size()},
          {"cycle_ms",
           {{"median", rounded(1e3 * quantile(mission.cycle_s, 0.5), 3)},
            {"p99", rounded(1e3 * quantile(mission.cycle_s, 0.99), 3)},
            {"worst", rounded(1e3 * quantile(mission.cycle_s, 1), 3)}}}};
}

std::string text_of(const Explored& explored) {
  const ExplorationMissionResult& mission = explored.mission;
  return fmt::format("simulated: {}; {:.1f} m in {:.0f} s, {} collisions, home to {:.1f} cm\n",
                     mission.end.why, mission.distance_m, mission.end.duration_s, mission.collisions,
                     100 * explored.truth.home_error_m);
}

/// The run to continue; it must have been driven by the same explorer.
Result<std::optional<InterruptedRun>> former_run(const ExploreOptions& options, const SessionOrigin& origin) {
  if (options.resumed.empty()) return std::optional<InterruptedRun>();
  const std::string file = options.resumed.string();
  std::error_code none;
  if (std::filesystem::equivalent(options.resumed, options.session, none))
    return Problem{{"--session"}, fmt::format("'{}' is the run to continue; name another directory", file)};
  auto truth = read_true_poses(options.resumed);
  if (!truth) return truth.problems();
  auto cycles = SessionCycles::open(options.resumed);
  if (!cycles) return cycles.problems();
  const SessionOrigin& driven = cycles->origin();
  if (driven.navigator != origin.navigator || driven.route != origin.route ||
      driven.parameters != origin.parameters)
    return Problem{
        {file, 0, "navigator"},
        fmt::format("the run was driven by '{} {}' with its parameters; it cannot be continued by '{} {}'",
                    driven.navigator, driven.route, origin.navigator, origin.route)};
  InterruptedRun run{std::move(*cycles), std::move(truth->T_map_vehicle)};
  if (run.T_world_vehicle.empty())
    return Problem{{file, 0, "/truth/pose"}, "is empty: only a simulated run can be continued"};
  return std::optional(std::move(run));
}

/// Explores, judges the result, and keeps what was learned.
Result<JudgedExploration> judge(const ExploreOptions& options, const ExplorationPlan& plan,
                                Console& console) {
  SessionOrigin origin = explorer_origin(plan.params, options);
  origin.seed = options.seed;
  origin.simulated = true;
  auto former = former_run(options, origin);
  if (!former) return former.problems();
  auto session =
      open_session(options.session, options.force, plan.setting.vehicle.description, origin, console.watcher);
  if (!session) return session.problems();
  auto explored = explore_once(options, plan, std::move(*former), *session, console.progress);
  if (!explored) return explored.problems();
  if (Problems problems = close(*session); !problems.empty()) return problems;
  Outcome outcome{.verb = "explore"};
  outcome.figures = figures_of(*explored);
  outcome.figures["seed"] = options.seed;
  outcome.figures["order"] = name_of(options.order);
  outcome.ok = outcome.figures["certificate"].get<bool>();
  if (options.compares) {
    ExploreOptions baseline = options;
    baseline.order = ExploringOrder::kNearest;
    std::optional<SessionRecord> unrecorded;
    const auto nearest = explore_once(baseline, plan, {}, unrecorded, console.progress);
    if (!nearest) return nearest.problems();
    outcome.figures["nearest_frontier_distance_m"] = rounded(nearest->mission.distance_m, 3);
    outcome.figures["nearest_frontier_certificate"] = has_certificate(*nearest);
  }
  outcome.text = text_of(*explored);
  Building building{plan.setting.world.name, explored->map.has_dominant_direction,
                    std::move(explored->map.walls)};
  building.places.push_back({kHomePlace, explored->map.T_map_vehicle.front()});
  building.corridors = std::move(explored->corridors);
  building.floor = std::move(explored->floor);
  return JudgedExploration{std::move(outcome),
                           std::move(building),
                           std::move(explored->mission.record),
                           std::move(explored->map.T_map_vehicle),
                           std::move(explored->mission.log),
                           plan.params.learner.mapping.segments};
}

/// The learned building, pictures of it, and the report.
std::vector<OutputFile> files_of(const JudgedExploration& explored) {
  const ExplorationPicture picture = picture_of(explored);
  return {{"building", "building.json", building_json(explored.building)},
          {"picture_png", "exploration.png", png(picture)},
          {"picture_svg", "exploration.svg", svg(picture)},
          {"report", "report.html", exploration_report(picture, explored.building, explored.outcome)}};
}

}  // namespace

Outcome explore_parameters() {
  ExplorerNavigatorParams params;
  return parameter_listing("explore", fields_of(params));
}

std::string exploring_vehicle(const ExploreOptions& options) {
  if (!options.vehicle.empty()) return options.vehicle;
  return options.sensor == ExploringSensor::kScanner ? "alv-scanner" : "alv";
}

Result<Outcome> run_explore(const ExploreOptions& options, Console& console) {
  auto setting =
      read_setting(options.world, exploring_vehicle(options), options.scenario, options.plan_pixel_m);
  if (!setting) return setting.problems();
  for (const std::string& warning : setting->warnings) console.warn(warning);
  return explore_in(options, std::move(*setting), console);
}

ExplorationPicture picture_of(const JudgedExploration& explored) {
  const std::string& text = explored.outcome.text;
  return {.floor = *explored.building.floor,
          .walls = explored.building.walls,
          .record = explored.record,
          .T_map_vehicle = explored.T_map_vehicle,
          .title = explored.building.name,
          .caption = text.substr(0, text.size() - 1)};
}

Result<JudgedExploration> explore_and_judge(const ExploreOptions& options, SimulationSetting setting,
                                            Console& console) {
  const auto plan = read_plan(options, std::move(setting));
  if (!plan) return plan.problems();
  return judge(options, *plan, console);
}

Result<Outcome> explore_in(const ExploreOptions& options, SimulationSetting setting, Console& console) {
  const auto plan = read_plan(options, std::move(setting));
  if (!plan) return plan.problems();
  const auto directory = OutputDirectory::open_if_named(
      options.out, options.force, {"building.json", "exploration.png", "exploration.svg", "report.html"});
  if (!directory) return directory.problems();
  auto explored = judge(options, *plan, console);
  if (!explored) return explored.problems();
  Outcome& outcome = explored->outcome;
  if (*directory) {
    auto written = (*directory)->write(files_of(*explored));
    if (!written) return written.problems();
    outcome.files = std::move(*written);
    outcome.text += "see " + outcome.files.at("report") + "\n";
  }
  return std::move(outcome);
}

}  // namespace aisle
