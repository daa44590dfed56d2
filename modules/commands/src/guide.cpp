#include "aisle/commands/guide.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

#include "aisle/commands/driven_vehicle.hpp"
#include "aisle/commands/parameter_listing.hpp"
#include "aisle/commands/set_down.hpp"
#include "aisle/connection/robot_goals.hpp"
#include "aisle/core/rounded.hpp"
#include "aisle/formats/whole_file.hpp"
#include "aisle/missions/exploration/guide_mission.hpp"
#include "aisle/missions/statistics.hpp"
#include "operated_vehicle.hpp"

namespace aisle {
namespace {

Problems in_file(Problems problems, const std::string& file) {
  for (Problem& problem : problems) {
    if (problem.where.file.empty() || problem.where.file == "building") problem.where.file = file;
  }
  return problems;
}

/// The origin of a session of the mission; its building and parameters are those of the options.
Result<SessionOrigin> read_origin(const GuideOptions& options, const std::string& goal) {
  GuideNavigatorParams params;
  FieldList fields = fields_of(params);
  if (Problems problems = options.parameters.apply_to(fields); !problems.empty()) return problems;
  auto building = read_whole_file(options.building);
  if (!building) return building.problems();
  const MissionStart elsewhere{.is_unknown = options.T_world_start.has_value(), .T_map_hint = {}};
  return GuideDriver::origin(params, std::move(*building), goal, options.told.value_or(elsewhere));
}

/// How it stood at the goals that have a heading; null: none has.
nlohmann::ordered_json headings_json(const std::vector<GoalHeading>& headings) {
  nlohmann::ordered_json rows;
  for (const GoalHeading& heading : headings)
    rows.push_back({{"place", heading.place + 1},
                    {"off_deg", rounded(to_degrees(heading.off_rad), 1)},
                    {"reached", heading.is_reached}});
  return rows;
}

/// Changes the goals on the way, and touches nothing else.
class GoalOperator final : public Operator {
 public:
  /// @param changes  null: nobody changes them
  explicit GoalOperator(std::function<std::vector<GoalChange>()> changes) : changes_(std::move(changes)) {}

  OperatorInput look(const OperatorView&) override {
    OperatorInput input;
    if (changes_) input.goal_changes = changes_();
    return input;
  }

 private:
  std::function<std::vector<GoalChange>()> changes_;
};

Result<Outcome> drive_to_goal(const char* verb, const GuideOptions& options, const SessionOrigin& origin,
                              GuideDriver& driver, DrivenVehicle& driven, Console& console) {
  GoalOperator person(console.goal_changes);
  OperatedVehicle vehicle(driven.vehicle(), &person);
  auto session = open_session(options.out, options.force, options.storage, vehicle, driven.truth(), origin,
                              driven.watcher(console));
  if (!session) return session.problems();
  const auto result = drive_guide_mission(vehicle, driven.truth(), driver, *session, console.progress);
  if (!result) return result.problems();
  if (const Problems problems = close_session(*session); !problems.empty()) return problems;

  const GuideNavigator& navigator = driver.navigator();
  const Building& building = driver.building();
  const Footprint& footprint = vehicle.description().footprint;
  const Goal& sent = driver.goal();
  const auto& headings = navigator.headings();
  const bool faces_right =
      std::all_of(headings.begin(), headings.end(), [](const GoalHeading& h) { return h.is_reached; });
  Outcome outcome{.verb = verb, .ok = result->end.arrived && faces_right && result->is_unharmed()};
  outcome.figures = known_figures(
      {{"arrived", result->end.arrived},
       {"why", result->end.why},
       {"places", sent.places.size()},
       {"places_reached", navigator.places_reached()},
       {"headings", headings_json(headings)},
       {"ways_closed", navigator.ways_closed()},
       {"times_lost", driver.times_lost()},
       {"distance_m", rounded(result->distance_m(), 3)},
       {"shortest_m", rounded(sent.shortest_m, 3)},
       {"collisions", if_known(result->collisions())},
       {"duration_s", rounded(result->end.duration_s, 1)},
       {"graph_coverage", rounded(graph_coverage(building.corridors, result->T_map_vehicle, footprint), 4)},
       {"cycle_ms",
        {{"median", rounded(1e3 * quantile(result->cycle_s, 0.5), 3)},
         {"p99", rounded(1e3 * quantile(result->cycle_s, 0.99), 3)}}}});
  driven.add_to(outcome.figures);
  if (!options.out.empty()) outcome.files["session"] = options.out.string();
  outcome.text = fmt::format("{}{}{}{}; {:.1f} m in {:.0f} s (the shortest path is {:.1f} m){}\n",
                             result->is_simulated() ? "simulated: " : "", result->end.state,
                             result->end.why.empty() ? "" : ": ", result->end.why, result->distance_m(),
                             result->end.duration_s, sent.shortest_m, collisions_text(*result));
  return outcome;
}

/// Drives to the goals that people point at in the robot's viewer, until the robot ends it or the user does.
Result<Outcome> follow_goals_of_robot(const GuideOptions& options, Console& console) {
  if (!options.out.empty())
    return Problem{{"--out"}, "needs PLACE: goals from a robot's viewer cannot be replayed"};
  GuideNavigatorParams params;
  FieldList fields = fields_of(params);
  if (Problems problems = options.parameters.apply_to(fields); !problems.empty()) return problems;
  auto building = read_whole_file(options.building);
  if (!building) return building.problems();
  const auto robot = connect_robot(options.connection, DrivenBy::kScanner, console);
  if (!robot) return robot.problems();
  ConnectedVehicle& vehicle = *(*robot)->vehicle;
  const auto goals = RobotGoals::open(*(*robot)->wire, (*robot)->connection, console.warn);
  if (!goals) return goals.problems();
  RobotGoals& asked = **goals;
  const auto goal = [&asked]() -> std::optional<GoalPlace> {
    const auto T_map = asked.take_goal();
    return T_map ? std::optional(GoalPlace{T_map->position(), T_map->theta}) : std::nullopt;
  };
  auto follower = GoalFollower::make(params, *building, vehicle.description(),
                                     {goal, [&asked] { return asked.take_initial_pose(); }, console.warn});
  if (!follower) return in_file(follower.problems(), options.building.string());
  auto shown = open_session({}, false, options.storage, vehicle, nullptr, {}, (*robot)->viewer.get());
  if (!shown) return shown.problems();
  console.warn("waits for goals on " + (*robot)->connection.topic("goal_pose"));
  const auto result = follow_goals(vehicle, **follower, *shown, console.progress);
  if (!result) return result.problems();
  Outcome outcome{.verb = "go", .ok = false};
  outcome.figures = {{"simulated", false},
                     {"goals", (*follower)->goals()},
                     {"goals_reached", (*follower)->goals_reached()},
                     {"why", result->end.why},
                     {"distance_m", rounded(result->distance_m(), 3)},
                     {"duration_s", rounded(result->end.duration_s, 1)},
                     {"connection", counts_json(vehicle.counts())}};
  outcome.text = fmt::format("{}; {} of {} goals reached, {:.1f} m\n", result->end.why,
                             (*follower)->goals_reached(), (*follower)->goals(), result->distance_m());
  return outcome;
}

Result<Outcome> run_goal(const char* verb, const GuideOptions& options, const std::string& goal,
                         Console& console) {
  auto origin = read_origin(options, goal);
  if (!origin) return origin.problems();
  const auto opened = DrivenVehicle::open({.connection = options.connection,
                                           .world = options.world,
                                           .vehicle = options.vehicle,
                                           .scenario = options.scenario,
                                           .plan_pixel_m = options.plan_pixel_m,
                                           .seed = options.seed},
                                          DrivenBy::kScanner, console);
  if (!opened) return opened.problems();
  DrivenVehicle& driven = **opened;
  if (driven.setting() != nullptr) {
    driven.setting()->vehicle.description.cameras.clear();
    origin->seed = options.seed;
  }
  const auto driver = GuideDriver::make(*origin, driven.description());
  if (!driver) return in_file(driver.problems(), options.building.string());
  if (Problems problems = set_down_at_home_or(options.T_world_start, driven, options.seed); !problems.empty())
    return problems;
  return drive_to_goal(verb, options, *origin, **driver, driven, console);
}

}  // namespace

Outcome guide_parameters() {
  GuideNavigatorParams params;
  return parameter_listing("go", fields_of(params));
}

Result<Outcome> run_go(const GuideOptions& options, Console& console) {
  if (options.places.empty()) return follow_goals_of_robot(options, console);
  return run_goal("go", options, GuideDriver::go_text(options.places), console);
}

Result<Outcome> run_patrol(const GuideOptions& options, Console& console) {
  return run_goal("patrol", options, "patrol " + std::to_string(options.rounds), console);
}

}  // namespace aisle
