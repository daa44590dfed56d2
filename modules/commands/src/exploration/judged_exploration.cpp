#include "aisle/commands/exploration/judged_exploration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "aisle/commands/connected_robot.hpp"
#include "aisle/commands/plan_reading.hpp"
#include "aisle/core/rounded.hpp"
#include "aisle/evaluation/exploration/exploration_evaluation.hpp"
#include "aisle/formats/sessions/session_cycles.hpp"
#include "aisle/formats/sessions/session_truth.hpp"
#include "aisle/learning/corridors/corridor_tracing.hpp"
#include "aisle/learning/walls/map_building.hpp"
#include "aisle/maps/grazing_walls.hpp"
#include "aisle/missions/exploration/exploration_mission.hpp"
#include "aisle/missions/exploration/explorer_driver.hpp"
#include "aisle/missions/statistics.hpp"
#include "aisle/simulation/vehicle/simulated_vehicle.hpp"
#include "exploration/exploration_check.hpp"
#include "exploration/exploring_start.hpp"

namespace aisle {
namespace {

ExploringChoice choice_of(const ExploreOptions& options) {
  return {options.order, options.sensor, options.camera};
}

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

struct Explored {
  ExplorationMissionResult mission;
  MapResult map;
  FloorGrid floor;
  CorridorGraph corridors;
  std::optional<ExplorationScore> truth;  ///< learned building against the ground truth, where that is known
};

/// What an exploration is done with.
struct Exploring {
  const ExploreOptions& options;
  const ExplorerNavigatorParams& params;
  Progress& progress;
};

Result<Explored> explore_once(const Exploring& exploring, Vehicle& vehicle, const TruthSource* truth,
                              std::optional<InterruptedRun> former, std::optional<SessionRecord>& session) {
  const ExplorerNavigatorParams& params = exploring.params;
  const auto explorer =
      make_explorer(explorer_origin(params, choice_of(exploring.options)), vehicle.description());
  if (!explorer) return explorer.problems();
  ExplorerNavigator& navigator = **explorer;
  auto mission = drive_exploration(vehicle, truth, navigator, std::move(former), session, exploring.progress);
  if (!mission) return mission.problems();
  if (mission->log.scans.empty())
    return Problem{{"explore"}, "ended before the first scan was taken: " + mission->end.why};
  MapResult map = build_map(mission->log, params.learner.mapping,
                            {.odometry_delay_s = 0.0, .odometry_noise = true}, false, exploring.progress);
  FloorGrid floor = navigator.learner().floor_from(map.T_map_vehicle);
  draw_grazing_walls(map.walls, floor);
  CorridorGraph corridors = trace_corridors(floor, map.T_map_vehicle.front().position(), {});
  return Explored{std::move(*mission), std::move(map), std::move(floor), std::move(corridors), {}};
}

SensorField sensor_field(const ExplorationPlan& plan, const LaserLog& log) {
  const auto& markers = plan.setting.vehicle.description.laser_markers;
  const std::size_t beams = log.scans.front().ranges_m.size();
  return {.T_vehicle_sensor = log.laser().T_vehicle_laser,
          .reach_m = plan.params.learner.view.reach_m,
          .width_rad = log.laser().angle_step_rad * static_cast<double>(beams - 1),
          .height_m = markers ? markers->height_m : plan.setting.vehicle.simulated.scanner.height_m};
}

/// Explores in the simulator, and compares what was learned with the world.
Result<Explored> explore_world(const Exploring& exploring, const ExplorationPlan& plan,
                               SimulatedVehicle& simulated, std::optional<InterruptedRun> former,
                               std::optional<SessionRecord>& session) {
  auto explored = explore_once(exploring, simulated, &simulated, std::move(former), session);
  if (!explored) return explored;
  const std::vector<Pose2>& T_world_scan = explored->mission.T_world_scan;
  explored->truth = evaluate_exploration(
      plan.setting.world, plan.setting.vehicle.description, sensor_field(plan, explored->mission.log),
      {T_world_scan, map_in_world(explored->map.T_map_vehicle, T_world_scan), explored->floor,
       explored->map.walls});
  return explored;
}

bool has_certificate(const Explored& explored) {
  return explored.mission.record.certified() && explored.mission.is_unharmed() &&
         (!explored.truth || explored.truth->covered_share >= kCompleteShare);
}

nlohmann::ordered_json figures_of(const Explored& explored) {
  const ExplorationMissionResult& mission = explored.mission;
  const auto of_truth = [&](double (*figure_of)(const ExplorationScore&), int decimals) {
    return explored.truth ? nlohmann::ordered_json(rounded(figure_of(*explored.truth), decimals))
                          : nlohmann::ordered_json();
  };
  using Score = const ExplorationScore&;
  return known_figures(
      {{"simulated", mission.is_simulated()},
       {"covered_share", of_truth([](Score truth) { return truth.covered_share; }, 4)},
       {"mapped_share", of_truth([](Score truth) { return truth.mapped_share; }, 4)},
       {"came_home", mission.record.came_home},
       {"home_error_m", of_truth([](Score truth) { return truth.home_error_m; }, 4)},
       {"home_error_deg", of_truth([](Score truth) { return to_degrees(truth.home_error_rad); }, 3)},
       {"collisions", if_known(mission.collisions())},
       {"distance_m", rounded(mission.distance_m(), 3)},
       {"duration_s", rounded(mission.end.duration_s, 1)},
       {"graph_bound_m", of_truth([](Score truth) { return truth.graph_bound_m; }, 3)},
       {"crossings", explored.corridors.count(CorridorNode::Kind::kCrossing)},
       {"dead_ends", explored.corridors.count(CorridorNode::Kind::kEnd)},
       {"wall_rmse_m", of_truth([](Score truth) { return truth.walls.rmse_m; }, 4)},
       {"wall_missed_share", of_truth([](Score truth) { return truth.walls.missed_share(); }, 4)},
       {"wall_false_share", of_truth([](Score truth) { return truth.walls.false_share(); }, 4)},
       {"free_m2", rounded(explored.floor.free_m2(), 2)},
       {"certificate", has_certificate(explored)},
       {"ended_because",
        mission.record.ended_because.empty() ? mission.end.why : mission.record.ended_because},
       {"loop_closures", explored.map.loop_closures.size()},
       {"cycle_ms",
        {{"median", rounded(1e3 * quantile(mission.cycle_s, 0.5), 3)},
         {"p99", rounded(1e3 * quantile(mission.cycle_s, 0.99), 3)},
         {"worst", rounded(1e3 * quantile(mission.cycle_s, 1), 3)}}}});
}

std::string text_of(const Explored& explored) {
  const ExplorationMissionResult& mission = explored.mission;
  std::string text = fmt::format("{}{}; {:.1f} m in {:.0f} s", mission.is_simulated() ? "simulated: " : "",
                                 mission.end.why, mission.distance_m(), mission.end.duration_s);
  if (explored.truth)
    text += fmt::format(", {} collisions, home to {:.1f} cm", mission.truth->collisions,
                        100 * explored.truth->home_error_m);
  return text + "\n";
}

/// The run to continue; it must have been driven by the same explorer.
Result<std::optional<InterruptedRun>> former_run(const ExploreOptions& options, const SessionOrigin& origin,
                                                 bool is_simulated) {
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
  if (is_simulated && run.T_world_vehicle.empty())
    return Problem{{file, 0, "/truth/pose"}, "is empty: the simulator cannot continue the run of a robot"};
  if (!is_simulated && !run.T_world_vehicle.empty())
    return Problem{{file, 0, "/truth/pose"}, "was simulated: a robot cannot continue that run"};
  return std::optional(std::move(run));
}

JudgedExploration judged(const ExplorerNavigatorParams& params, std::string building_name,
                         Explored explored) {
  Outcome outcome{.verb = "explore"};
  outcome.figures = figures_of(explored);
  outcome.ok = outcome.figures["certificate"].get<bool>();
  outcome.text = text_of(explored);
  Building building{std::move(building_name), explored.map.has_dominant_direction,
                    std::move(explored.map.walls)};
  building.places.push_back({kHomePlace, explored.map.T_map_vehicle.front()});
  building.corridors = std::move(explored.corridors);
  building.floor = std::move(explored.floor);
  return {std::move(outcome),
          std::move(building),
          std::move(explored.mission.record),
          std::move(explored.map.T_map_vehicle),
          std::move(explored.mission.log),
          params.learner.mapping.segments};
}

}  // namespace

std::string exploring_vehicle(const ExploreOptions& options) {
  if (!options.vehicle.empty()) return options.vehicle;
  return options.sensor == ExploringSensor::kScanner ? "alv-scanner" : "alv";
}

Result<ExplorationPlan> read_exploration_plan(const ExploreOptions& options, SimulationSetting setting) {
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

/// Whether the vehicle was where this world has no room for it, more often than where it brushed something.
bool drove_elsewhere(const SimulationSetting& setting, const std::vector<Pose2>& T_world_vehicle) {
  constexpr std::size_t kLooks = 200, kBrushesMax = 4;
  const std::size_t step = std::max<std::size_t>(1, T_world_vehicle.size() / kLooks);
  std::size_t outside = 0;
  for (std::size_t i = 0; i < T_world_vehicle.size(); i += step)
    outside += !fits(setting.world, setting.vehicle.description.footprint, T_world_vehicle[i]);
  return outside > kBrushesMax;
}

Result<JudgedExploration> explore_and_judge(const ExploreOptions& options, const ExplorationPlan& plan,
                                            Console& console) {
  SessionOrigin origin = explorer_origin(plan.params, choice_of(options));
  origin.seed = options.seed;
  auto former = former_run(options, origin, true);
  if (!former) return former.problems();
  if (*former && drove_elsewhere(plan.setting, (*former)->T_world_vehicle))
    return Problem{{options.resumed.string()},
                   fmt::format("its path goes through walls of '{}': it was driven in another world",
                               plan.setting.world.name)};
  SimulatedVehicle vehicle = vehicle_in(
      plan.setting, *former ? (*former)->T_world_vehicle.back() : plan.T_world_start, options.seed);
  auto session = open_session(options.session, options.force, options.storage, vehicle, &vehicle, origin,
                              console.watcher);
  if (!session) return session.problems();
  auto explored =
      explore_world({options, plan.params, console.progress}, plan, vehicle, std::move(*former), *session);
  if (!explored) return explored.problems();
  if (Problems problems = close_session(*session); !problems.empty()) return problems;
  JudgedExploration result = judged(plan.params, plan.setting.world.name, std::move(*explored));
  result.outcome.figures["seed"] = options.seed;
  result.outcome.figures["order"] = name_of(options.order);
  if (options.compares) {
    ExploreOptions baseline = options;
    baseline.order = ExploringOrder::kNearest;
    SimulatedVehicle another = vehicle_in(plan.setting, plan.T_world_start, options.seed);
    std::optional<SessionRecord> unrecorded;
    const auto nearest =
        explore_world({baseline, plan.params, console.progress}, plan, another, {}, unrecorded);
    if (!nearest) return nearest.problems();
    result.outcome.figures["nearest_frontier_distance_m"] = rounded(nearest->mission.distance_m(), 3);
    result.outcome.figures["nearest_frontier_certificate"] = has_certificate(*nearest);
    result.outcome.text += fmt::format("nearest frontier, in the same world: {:.0f} m of path, {}\n",
                                       nearest->mission.distance_m(),
                                       has_certificate(*nearest) ? "explored as well" : "not all explored");
  }
  return result;
}

Result<JudgedExploration> explore_with_robot(const ExploreOptions& options, Console& console) {
  ExplorerNavigatorParams params;
  FieldList fields = fields_of(params);
  if (Problems problems = options.parameters.apply_to(fields); !problems.empty()) return problems;
  const SessionOrigin origin = explorer_origin(params, choice_of(options));
  auto former = former_run(options, origin, false);
  if (!former) return former.problems();
  auto robot = connect_robot(options.connection, DrivenBy::kScanner, console);
  if (!robot) return robot.problems();
  ConnectedVehicle& vehicle = *(*robot)->vehicle;
  auto session = open_session(options.session, options.force, options.storage, vehicle, nullptr, origin,
                              (*robot)->viewer.get());
  if (!session) return session.problems();
  auto explored =
      explore_once({options, params, console.progress}, vehicle, nullptr, std::move(*former), *session);
  if (!explored) return explored.problems();
  if (Problems problems = close_session(*session); !problems.empty()) return problems;
  JudgedExploration result = judged(params, options.connection.stem().string(), std::move(*explored));
  result.outcome.figures["order"] = name_of(options.order);
  result.outcome.figures["connection"] = counts_json(vehicle.counts());
  return result;
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

}  // namespace aisle
