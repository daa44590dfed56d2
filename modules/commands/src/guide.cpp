#include "aisle/commands/guide.hpp"

#include <fmt/format.h>

#include <memory>
#include <utility>

#include "aisle/commands/parameter_listing.hpp"
#include "aisle/commands/set_down.hpp"
#include "aisle/core/rounded.hpp"
#include "aisle/formats/whole_file.hpp"
#include "aisle/missions/exploration/guide_mission.hpp"
#include "aisle/missions/statistics.hpp"

namespace aisle {
namespace {

/// Everything a mission needs, read and checked.
struct GuidePlan {
  SimulationSetting setting;
  Pose2 T_world_start;
  SessionOrigin origin;
  std::unique_ptr<GuideDriver> driver;
};

Problems in_file(Problems problems, const std::string& file) {
  for (Problem& problem : problems) {
    if (problem.where.file.empty() || problem.where.file == "building") problem.where.file = file;
  }
  return problems;
}

Result<GuidePlan> read_guide_plan(const GuideOptions& options, const std::string& goal) {
  GuideNavigatorParams params;
  FieldList fields = fields_of(params);
  if (Problems problems = options.parameters.apply_to(fields); !problems.empty()) return problems;
  auto building = read_whole_file(options.building);
  if (!building) return building.problems();
  auto setting = read_setting(options.world, options.vehicle, options.scenario, options.plan_pixel_m);
  if (!setting) return setting.problems();
  setting->vehicle.description.cameras.clear();
  const auto start = start_in(*setting);
  if (!start) return start.problems();
  GuidePlan plan{std::move(*setting), *start, GuideDriver::origin(params, std::move(*building), goal), {}};
  plan.origin.seed = options.seed;
  auto driver = GuideDriver::make(plan.origin, plan.setting.vehicle.description);
  if (!driver) return in_file(driver.problems(), options.building.string());
  plan.driver = std::move(*driver);
  return plan;
}

Result<Outcome> run_goal(const char* verb, const GuideOptions& options, const std::string& goal,
                         Console& console) {
  const auto plan = read_guide_plan(options, goal);
  if (!plan) return plan.problems();
  for (const std::string& warning : plan->setting.warnings) console.warn(warning);
  SimulatedVehicle vehicle = vehicle_in(
      plan->setting, set_down_at_home(plan->setting, plan->T_world_start, options.seed), options.seed);
  auto session = open_session(options.out, options.force, options.storage, vehicle, &vehicle, plan->origin,
                              console.watcher);
  if (!session) return session.problems();
  const auto result = drive_guide_mission(vehicle, &vehicle, *plan->driver, *session, console.progress);
  if (!result) return result.problems();
  if (const Problems problems = close_session(*session); !problems.empty()) return problems;

  const GuideNavigator& navigator = plan->driver->navigator();
  const Building& building = plan->driver->building();
  const Footprint& footprint = plan->setting.vehicle.description.footprint;
  const Goal& sent = plan->driver->goal();
  Outcome outcome{.verb = verb, .ok = result->end.arrived && result->is_unharmed()};
  outcome.figures = known_figures(
      {{"simulated", result->is_simulated()},
       {"seed", options.seed},
       {"arrived", result->end.arrived},
       {"why", result->end.why},
       {"places", sent.p_map_places.size()},
       {"places_reached", navigator.places_reached()},
       {"ways_closed", navigator.ways_closed()},
       {"distance_m", rounded(result->distance_m(), 3)},
       {"shortest_m", rounded(sent.shortest_m, 3)},
       {"collisions", if_known(result->collisions())},
       {"duration_s", rounded(result->end.duration_s, 1)},
       {"graph_coverage", rounded(graph_coverage(building.corridors, result->T_map_vehicle, footprint), 4)},
       {"cycle_ms",
        {{"median", rounded(1e3 * quantile(result->cycle_s, 0.5), 3)},
         {"p99", rounded(1e3 * quantile(result->cycle_s, 0.99), 3)}}}});
  if (!options.out.empty()) outcome.files["session"] = options.out.string();
  outcome.text = fmt::format("{}{}{}{}; {:.1f} m in {:.0f} s (the shortest path is {:.1f} m){}\n",
                             result->is_simulated() ? "simulated: " : "", result->end.state,
                             result->end.why.empty() ? "" : ": ", result->end.why, result->distance_m(),
                             result->end.duration_s, sent.shortest_m, collisions_text(*result));
  return outcome;
}

}  // namespace

Outcome guide_parameters() {
  GuideNavigatorParams params;
  return parameter_listing("go", fields_of(params));
}

Result<Outcome> run_go(const GuideOptions& options, Console& console) {
  return run_goal("go", options, "go " + options.place, console);
}

Result<Outcome> run_patrol(const GuideOptions& options, Console& console) {
  return run_goal("patrol", options, "patrol " + std::to_string(options.rounds), console);
}

}  // namespace aisle
