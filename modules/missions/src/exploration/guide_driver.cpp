#include "aisle/missions/exploration/guide_driver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <utility>

#include "aisle/core/rounded.hpp"
#include "aisle/formats/buildings/building_json.hpp"
#include "aisle/missions/changed_parameters.hpp"

namespace aisle {
namespace {

constexpr int kRoundsMax = 1000;
constexpr std::size_t kTimesLostMax = 3;  // then the building is not what it was

Problem place_problem(const std::string& what) {
  return {{"", 0, "PLACE"}, what};
}

/// "x,y" in metres.
std::optional<Vec2> point_of(const std::string& text) {
  Vec2 p = Vec2::Zero();
  const char* const end = text.data() + text.size();
  const auto x = std::from_chars(text.data(), end, p.x());
  if (x.ec != std::errc() || x.ptr == end || *x.ptr != ',') return std::nullopt;
  const auto y = std::from_chars(x.ptr + 1, end, p.y());
  if (y.ec != std::errc() || y.ptr != end || !p.allFinite()) return std::nullopt;
  return p;
}

constexpr double kHeadingMax_deg = 360;

/// "x,y" in metres, or "x,y,heading_deg".
std::optional<GoalPlace> goal_place_of(const std::string& text) {
  if (const auto point = point_of(text)) return GoalPlace{*point};
  const std::size_t comma = text.rfind(',');
  const auto point = comma == std::string::npos ? std::nullopt : point_of(text.substr(0, comma));
  double heading_deg = 0;
  const char* const end = text.data() + text.size();
  if (!point) return std::nullopt;
  const auto [rest, error] = std::from_chars(text.data() + comma + 1, end, heading_deg);
  if (error != std::errc() || rest != end || !(std::abs(heading_deg) <= kHeadingMax_deg)) return std::nullopt;
  return GoalPlace{*point, wrap_angle(heading_deg * kDegree)};
}

std::string known_names(const Building& building) {
  std::vector<std::string> names;
  for (const MapPlace& place : building.places) names.push_back(place.name);
  for (std::size_t i = 0; i < building.corridors.nodes.size(); ++i)
    names.push_back(building.corridors.name_of(i));
  return fmt::format("{}", fmt::join(names, ", "));
}

GoalPlace goal_at(const MapPlace& place) {
  const Pose2& T = place.T_map_place;
  return {T.position(), place.has_heading ? std::optional(T.theta) : std::nullopt};
}

/// Where `patrol` ends. A building without a home has it at its origin, and then nobody asked for a heading.
GoalPlace home_goal(const Building& building) {
  for (const MapPlace& place : building.places) {
    if (place.name == kHomePlace) return goal_at(place);
  }
  return {home_of(building).position()};
}

/// A place, or a point without a name.
struct FoundGoal {
  GoalPlace place;
  std::string name;
};

Result<FoundGoal> find_goal(const Building& building, const std::string& text) {
  for (const MapPlace& place : building.places) {
    if (place.name == text) return FoundGoal{goal_at(place), text};
  }
  for (std::size_t i = 0; i < building.corridors.nodes.size(); ++i) {
    if (building.corridors.name_of(i) == text) return FoundGoal{{building.corridors.nodes[i].p_map}, text};
  }
  const auto place = goal_place_of(text);
  if (!place)
    return place_problem(fmt::format("'{}' is unknown; there are {}, and any x,y or x,y,heading_deg", text,
                                     known_names(building)));
  if (building.floor->at(place->p_map) != Floor::kFree)
    return place_problem(fmt::format("nothing is known at {} that could be driven on", text));
  return FoundGoal{*place, ""};
}

/// Length of the path from one point to another along the corridors, with the legs to and from them.
double shortest_m(const CorridorGraph& graph, const Vec2& from, const Vec2& to) {
  const auto first = graph.nearest(from), last = graph.nearest(to);
  if (!first || !last) return (to - from).norm();
  const auto path = shortest_path(graph, *first, *last);
  return path ? first->lateral_m + path->length_m() + last->lateral_m : 0;
}

/// From home to one place after the other.
double shortest_through_m(const Building& building, const std::vector<GoalPlace>& places) {
  double length_m = 0;
  Vec2 p_map_from = home_of(building).position();
  for (const GoalPlace& place : places) {
    length_m += shortest_m(building.corridors, p_map_from, place.p_map);
    p_map_from = place.p_map;
  }
  return length_m;
}

std::size_t node_nearest(const CorridorGraph& graph, const Vec2& p_map) {
  const auto nearest = std::min_element(graph.nodes.begin(), graph.nodes.end(),
                                        [&](const CorridorNode& a, const CorridorNode& b) {
                                          return (a.p_map - p_map).norm() < (b.p_map - p_map).norm();
                                        });
  return static_cast<std::size_t>(nearest - graph.nodes.begin());
}

constexpr const char* kGoals = "goals";
constexpr const char* kStartMark = "; start ";  // between goal and start in a session's record

std::string start_text(const MissionStart& start) {
  if (start.is_home()) return "";
  if (start.is_unknown) return std::string(kStartMark) + "unknown";
  const Pose2& T = *start.T_map_hint;
  return fmt::format("{}{},{},{}", kStartMark, T.x, T.y, T.theta);
}

/// "unknown", or "x,y,heading" in metres and radians.
Result<MissionStart> start_of(const std::string& text) {
  if (text.empty()) return MissionStart{};
  if (text == "unknown") return MissionStart{.is_unknown = true, .T_map_hint = {}};
  const std::size_t comma = text.rfind(',');
  const auto point = comma == std::string::npos ? std::nullopt : point_of(text.substr(0, comma));
  double heading_rad = 0;
  const char* const end = text.data() + text.size();
  if (point) {
    const auto [rest, error] = std::from_chars(text.data() + comma + 1, end, heading_rad);
    if (error == std::errc() && rest == end && std::isfinite(heading_rad))
      return MissionStart{.is_unknown = false, .T_map_hint = Pose2{point->x(), point->y(), heading_rad}};
  }
  return Problem{{"", 0, "route"}, fmt::format("'{}' is no start", text)};
}

Result<Goal> goal_of(const Building& building, const std::string& text) {
  const std::size_t space = text.find(' ');
  const std::string verb = text.substr(0, space),
                    rest = space == std::string::npos ? "" : text.substr(space + 1);
  if (verb == "go") return goal_to(building, rest);
  if (verb == kGoals) {
    const auto places = nlohmann::json::parse(rest, nullptr, false);
    const bool are_texts =
        places.is_array() && !places.empty() &&
        std::all_of(places.begin(), places.end(), [](const auto& p) { return p.is_string(); });
    if (are_texts) return goal_through(building, places.get<std::vector<std::string>>());
  }
  int rounds = 0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), rounds);
  if (verb == "patrol" && error == std::errc() && end == rest.data() + rest.size())
    return patrol_goal(building, rounds);
  return Problem{{"", 0, "route"},
                 fmt::format("'{}' is neither 'go PLACE', 'goals [PLACES]' nor 'patrol ROUNDS'", text)};
}

}  // namespace

Problems check_guidable(const Building& building, const VehicleDescription& vehicle) {
  Problems problems;
  const auto need = [&](bool is_there, const char* key) {
    if (!is_there)
      problems.push_back(
          {{"", 0, key}, "are missing: the building was not explored; 'aisle explore' does that"});
  };
  need(!building.walls.walls.empty(), "walls");
  need(!building.corridors.nodes.empty(), "corridors");
  need(building.floor && !building.floor->known().empty(), "floor.rows");
  if (!vehicle.scanner) problems.push_back({{"", 0, "scanner"}, "is missing: the vehicle cannot see walls"});
  return problems;
}

Result<Goal> goal_to(const Building& building, const std::string& place) {
  return goal_through(building, {place});
}

Result<Goal> goal_through(const Building& building, const std::vector<std::string>& places) {
  Goal goal;
  Problems problems;
  std::size_t number = 0;
  const auto refuse = [&](Problem problem) {
    if (places.size() > 1) problem.what = fmt::format("goal {}: {}", number, problem.what);
    problems.push_back(std::move(problem));
  };
  for (const std::string& text : places) {
    ++number;
    const auto found = find_goal(building, text);
    if (!found) {
      for (const Problem& problem : found.problems()) refuse(problem);
      continue;
    }
    if (const Zone* zone = keep_out_around(building.zones, found->place.p_map))
      refuse(place_problem(fmt::format("'{}' lies in the {}", text, words_for(*zone))));
    goal.places.push_back(found->place);
    goal.names.push_back(found->name);
  }
  if (!problems.empty()) return problems;
  goal.shortest_m = shortest_through_m(building, goal.places);
  return goal;
}

std::string goals_json(const Goal& goal, std::size_t reached) {
  nlohmann::ordered_json goals = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < goal.names.size(); ++i) {
    const GoalPlace& place = goal.places[i];
    nlohmann::ordered_json json;
    if (!goal.names[i].empty()) {
      json = {{"place", goal.names[i]}};
    } else {
      json = {{"x_m", rounded(place.p_map.x(), 3)}, {"y_m", rounded(place.p_map.y(), 3)}};
      if (place.heading_rad) json["heading_deg"] = rounded(to_degrees(*place.heading_rad), 1);
    }
    goals.push_back(std::move(json));
  }
  return nlohmann::ordered_json{{"goals", std::move(goals)}, {"reached", reached}}.dump(
      -1, ' ', false, nlohmann::json::error_handler_t::replace);
}

Result<Goal> patrol_goal(const Building& building, int rounds) {
  if (rounds < 1 || rounds > kRoundsMax)
    return Problem{{"", 0, "--rounds"}, fmt::format("{} is outside 1 .. {}", rounds, kRoundsMax)};
  const CorridorGraph& graph = building.corridors;
  const Vec2 p_map_home = home_of(building).position();
  const std::size_t start = node_nearest(graph, p_map_home);
  const CorridorPath round = patrol_path(graph, start);
  Goal goal;
  goal.shortest_m = 2 * shortest_m(graph, p_map_home, graph.nodes[start].p_map) + rounds * round.length_m();
  for (int i = 0; i < rounds; ++i) {
    for (const CorridorLeg& leg : round.legs) {
      const Corridor& corridor = graph.corridors[leg.corridor];
      goal.places.push_back({corridor.at((leg.from_m + leg.to_m) / 2)});
      goal.places.push_back({corridor.at(leg.to_m)});
    }
  }
  std::erase_if(goal.places, [&](const GoalPlace& place) {
    return keep_out_around(building.zones, place.p_map) != nullptr;
  });
  goal.places.push_back(home_goal(building));
  return goal;
}

std::string GuideDriver::go_text(const std::vector<std::string>& places) {
  if (places.size() == 1) return "go " + places.front();
  return fmt::format("{} {}", kGoals,
                     nlohmann::json(places).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

SessionOrigin GuideDriver::origin(const GuideNavigatorParams& params, std::string building, std::string goal,
                                  const MissionStart& start) {
  SessionOrigin origin;
  origin.navigator = kName;
  origin.parameters = changed_parameters(params);
  origin.building = std::move(building);
  origin.route = std::move(goal) + start_text(start);
  return origin;
}

Result<std::unique_ptr<GuideDriver>> GuideDriver::make(const SessionOrigin& origin,
                                                       const VehicleDescription& vehicle) {
  auto building = parse_building(origin.building, "building");
  if (!building) return building.problems();
  GuideNavigatorParams params;
  if (Problems problems = assign_all(params, origin.parameters); !problems.empty()) return problems;
  if (Problems problems = check_guidable(*building, vehicle); !problems.empty()) return problems;
  const std::size_t mark = origin.route.find(kStartMark);
  auto goal = goal_of(*building, origin.route.substr(0, mark));
  if (!goal) return goal.problems();
  const auto start = start_of(
      mark == std::string::npos ? "" : origin.route.substr(mark + std::string_view(kStartMark).size()));
  if (!start) return start.problems();
  return std::make_unique<GuideDriver>(params, vehicle, std::move(*building), std::move(*goal), *start);
}

GuideDriver::GuideDriver(const GuideNavigatorParams& params, const VehicleDescription& vehicle,
                         Building building, Goal goal, const MissionStart& start)
    : vehicle_(vehicle),
      building_(std::move(building)),
      goal_(std::move(goal)),
      navigator_(params, vehicle, building_, home_of(building_), goal_.places, scanner_scans(vehicle)) {
  if (!start.is_home()) begin_finding(start.T_map_hint);
}

Decision GuideDriver::step(const Observation& observation) {
  for (const GoalChange& change : observation.operator_input.goal_changes) take(change, observation.stamp_s);
  if (finder_) return find(observation);
  Decision decision = guide(observation);
  if (!navigator_.is_lost(observation.stamp_s) || observation.bumper_pressed) return decision;
  if (++times_lost_ > kTimesLostMax) {
    decision.why =
        fmt::format("lost for the {}th time: what it sees does not fit this building", times_lost_);
    return decision;
  }
  begin_finding({});
  return {.state = "lost"};
}

void GuideDriver::take(const GoalChange& change, double stamp_s) {
  if (goal_.names.empty()) return;  // a patrol's places are not somebody's goals
  const std::size_t reached = navigator_.places_reached();
  if (!change.added.empty()) {
    const auto more = goal_to(building_, change.added);
    if (!more) return;
    goal_.places.push_back(more->places.front());
    goal_.names.push_back(more->names.front());
    navigator_.add_place(more->places.front());
  } else {
    const bool is_left = change.removed > reached && change.removed <= goal_.names.size();
    if (!is_left || goal_.names.size() - reached == 1) return;
    const std::size_t place = change.removed - 1;
    goal_.places.erase(goal_.places.begin() + static_cast<std::ptrdiff_t>(place));
    goal_.names.erase(goal_.names.begin() + static_cast<std::ptrdiff_t>(place));
    navigator_.remove_place(place, stamp_s);
  }
  goal_.shortest_m = shortest_through_m(building_, goal_.places);
}

/// On the way to one of several goals it says to which, and that the others are left out where it fails.
Decision GuideDriver::guide(const Observation& observation) {
  Decision decision = navigator_.step(observation);
  if (!goal_.is_queue() || decision.status == NavigatorStatus::kDone) return decision;
  const std::string which =
      fmt::format("goal {} of {}", navigator_.places_reached() + 1, goal_.places.size());
  decision.why = decision.why.empty() ? which : which + ": " + decision.why;
  return decision;
}

void GuideDriver::begin_finding(const std::optional<Pose2>& T_map_hint) {
  finder_ = std::make_unique<PlaceFinder>(PlaceFinderParams{}, vehicle_, building_, T_map_hint);
}

Decision GuideDriver::find(const Observation& observation) {
  Decision decision = finder_->step(observation);
  if (decision.status == NavigatorStatus::kFailed && times_lost_ > 0)
    decision.why = "lost on the way, and " + decision.why;
  if (decision.status != NavigatorStatus::kDone) return decision;
  navigator_.begin_at(finder_->localiser().T_map_vehicle(), observation.stamp_s);
  finder_.reset();
  return {.state = "found"};
}

}  // namespace aisle
