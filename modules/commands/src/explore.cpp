#include "aisle/commands/explore.hpp"

#include <fmt/format.h>

#include <utility>

#include "aisle/commands/output_directory.hpp"
#include "aisle/commands/parameter_listing.hpp"
#include "aisle/formats/building_json.hpp"
#include "aisle/learning/corridor_tracing.hpp"
#include "aisle/learning/map_building.hpp"
#include "aisle/simulation/simulated_vehicle.hpp"
#include "exploration_check.hpp"
#include "exploration_evaluation.hpp"
#include "exploration_mission.hpp"
#include "exploration_report.hpp"
#include "explore_in.hpp"
#include "rounded.hpp"
#include "simulated_record.hpp"
#include "statistics.hpp"

namespace aisle {
namespace {

/// All that an exploration is made of, read and checked.
struct ExplorationPlan {
  SimulationSetting setting;
  ExplorerNavigatorParams params;
  Pose2 T_world_start;
};

Problems check_sensor(const ExploreOptions& options, const VehicleDescription& vehicle) {
  const auto lacks = [&](const std::string& what) {
    return Problems{{{"--vehicle"}, fmt::format("'{}' has no {} to explore with", vehicle.name, what)}};
  };
  if (options.sensor == ExploringSensor::kScanner)
    return vehicle.scanner ? Problems{} : lacks("range scanner");
  if (!vehicle.laser_markers) return lacks("laser markers");
  return vehicle.camera(options.camera) != nullptr ? Problems{} : lacks("camera '" + options.camera + "'");
}

/// What does not serve to explore is switched off.
void keep_sensor(const ExploreOptions& options, VehicleDescription& vehicle) {
  const bool by_markers = options.sensor == ExploringSensor::kMarkers;
  if (by_markers) vehicle.scanner.reset();
  std::erase_if(vehicle.cameras, [&](const CameraDescription& camera) {
    return !by_markers || camera.name != options.camera;
  });
}

std::unique_ptr<SliceSensor> sensor_of(const ExploreOptions& options, const VehicleDescription& vehicle) {
  return options.sensor == ExploringSensor::kScanner ? scanner_slices(vehicle)
                                                     : marker_slices(vehicle, options.camera);
}

Result<ExplorationPlan> read_plan(const ExploreOptions& options, SimulationSetting setting) {
  ExplorationPlan plan;
  FieldList fields = fields_of(plan.params);
  if (Problems problems = options.parameters.apply_to(fields); !problems.empty()) return problems;
  plan.setting = std::move(setting);
  VehicleDescription& vehicle = plan.setting.vehicle.description;
  if (Problems problems = check_sensor(options, vehicle); !problems.empty()) return problems;
  keep_sensor(options, vehicle);
  if (options.T_world_start) {
    plan.T_world_start = *options.T_world_start;
  } else {
    const auto start = start_in(plan.setting);
    if (!start) return start.problems();
    plan.T_world_start = *start;
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
  ExplorationScore truth;  ///< how well the building is known, by the truth
};

SensorField field_of(const LaserScanner& fan, std::size_t beams, double reach_m, double height_m) {
  return {.T_vehicle_sensor = fan.T_vehicle_laser,
          .reach_m = reach_m,
          .width_rad = fan.angle_step_rad * static_cast<double>(beams - 1),
          .height_m = height_m};
}

Result<Explored> explore_once(const ExploreOptions& options, const ExplorationPlan& plan,
                              ExploringOrder order, std::optional<SessionRecord>& session,
                              Progress& progress) {
  const VehicleDescription& vehicle = plan.setting.vehicle.description;
  ExplorerNavigator navigator(plan.params, vehicle, order, sensor_of(options, vehicle));
  auto mission =
      drive_exploration(plan.setting, navigator, plan.T_world_start, options.seed, session, progress);
  if (!mission) return mission.problems();
  const LaserLog& log = mission->log;
  MapResult map = build_map(log, plan.params.learner.mapping, 0.0, false, progress);
  FloorGrid floor = navigator.learner().floor_from(map.T_map_vehicle);
  CorridorGraph corridors = trace_corridors(floor, map.T_map_vehicle.front().position(), {});
  const double height_m = vehicle.laser_markers ? vehicle.laser_markers->height_m
                                                : plan.setting.vehicle.simulated.scanner.height_m;
  const SensorField field =
      field_of(log.laser, log.scans.front().ranges_m.size(), plan.params.learner.view.reach_m, height_m);
  const ExplorationScore truth = evaluate_exploration(
      plan.setting.world, vehicle, field,
      {mission->T_world_slice, map_in_world(map.T_map_vehicle, mission->T_world_slice), floor, map.walls});
  return Explored{std::move(*mission), std::move(map), std::move(floor), std::move(corridors), truth};
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
          {"certificate", mission.record.certified() && mission.collisions == 0},
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

/// What was learned, pictures of it, and the report.
std::vector<OutputFile> files_of(const ExplorationPlan& plan, const Explored& explored,
                                 const Outcome& outcome) {
  Building building{plan.setting.world.name, explored.map.has_dominant_direction, explored.map.walls};
  building.corridors = explored.corridors;
  building.floor = explored.floor;
  const ExplorationPicture picture{.floor = explored.floor,
                                   .walls = explored.map.walls,
                                   .record = explored.mission.record,
                                   .T_map_vehicle = explored.map.T_map_vehicle,
                                   .title = building.name,
                                   .caption = outcome.text.substr(0, outcome.text.size() - 1)};
  return {{"building", "building.json", building_json(building)},
          {"picture_png", "exploration.png", png(picture)},
          {"picture_svg", "exploration.svg", svg(picture)},
          {"report", "report.html", exploration_report(picture, building, outcome)}};
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
  auto setting = read_setting(options.world, exploring_vehicle(options), options.scenario);
  if (!setting) return setting.problems();
  return explore_in(options, std::move(*setting), console);
}

Result<Outcome> explore_in(const ExploreOptions& options, SimulationSetting setting, Console& console) {
  const auto plan = read_plan(options, std::move(setting));
  if (!plan) return plan.problems();
  std::optional<OutputDirectory> out;
  if (!options.out.empty()) {
    auto opened = OutputDirectory::open(
        options.out, options.force, {"building.json", "exploration.png", "exploration.svg", "report.html"});
    if (!opened) return opened.problems();
    out = std::move(*opened);
  }
  SessionOrigin origin{.navigator = "explorer", .seed = options.seed, .simulated = true};
  auto session = open_session({}, false, plan->setting.vehicle.description, origin, console.watcher);
  if (!session) return session.problems();
  const auto explored = explore_once(options, *plan, options.order, *session, console.progress);
  if (!explored) return explored.problems();

  Outcome outcome{.verb = "explore"};
  outcome.figures = figures_of(*explored);
  outcome.figures["seed"] = options.seed;
  outcome.figures["order"] = name_of(options.order);
  outcome.ok = outcome.figures["certificate"].get<bool>();
  if (options.compares) {
    std::optional<SessionRecord> none;
    const auto nearest = explore_once(options, *plan, ExploringOrder::kNearest, none, console.progress);
    if (!nearest) return nearest.problems();
    outcome.figures["nearest_frontier_distance_m"] = rounded(nearest->mission.distance_m, 3);
  }
  outcome.text = text_of(*explored);
  if (out) {
    auto written = out->write(files_of(*plan, *explored, outcome));
    if (!written) return written.problems();
    outcome.files = std::move(*written);
  }
  return outcome;
}

}  // namespace aisle
