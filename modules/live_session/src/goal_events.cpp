#include "goal_events.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "aisle/core/rounded.hpp"

namespace aisle {
namespace {

using Json = nlohmann::json;

double number_in(const Json& goal, const char* key, int decimals) {
  return rounded(goal.at(key).get<double>(), decimals) + 0.0;  // and no minus zero
}

std::string name_of(const Json& goal) {
  if (goal.contains("place")) return goal.at("place").get<std::string>();
  std::string name = fmt::format("{:.2f}, {:.2f} m", number_in(goal, "x_m", 2), number_in(goal, "y_m", 2));
  if (goal.contains("heading_deg")) name += fmt::format(", {:.0f}°", number_in(goal, "heading_deg", 0));
  return name;
}

/// "desk (2/3)"; a single goal has no number.
std::string numbered(const MissionGoals& goals, std::size_t goal) {
  const std::string& name = goals.names[goal];
  return goals.names.size() == 1 ? name : fmt::format("{} ({}/{})", name, goal + 1, goals.names.size());
}

/// Goals are removed anywhere behind those that are reached, and added behind the last one.
void add_changes(const MissionGoals& before, const MissionGoals& now, std::vector<GoalEvent>& events) {
  std::size_t kept = std::min(before.reached, now.names.size());
  for (std::size_t i = before.reached; i < before.names.size(); ++i) {
    const bool is_kept = kept < now.names.size() && now.names[kept] == before.names[i];
    if (is_kept) {
      ++kept;
    } else {
      events.push_back({"goal_removed", before.names[i]});
    }
  }
  for (; kept < now.names.size(); ++kept) events.push_back({"goal_added", now.names[kept]});
}

bool has_another_next(const MissionGoals& before, const MissionGoals& now) {
  if (!now.are_left()) return false;
  return !before.are_left() || before.reached != now.reached ||
         before.names[before.reached] != now.names[now.reached];
}

}  // namespace

std::optional<MissionGoals> parse_goals(const std::string& goals_json) {
  try {
    const Json json = Json::parse(goals_json);
    MissionGoals goals;
    for (const Json& goal : json.at("goals")) goals.names.push_back(name_of(goal));
    goals.reached = std::min(json.at("reached").get<std::size_t>(), goals.names.size());
    return goals;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

std::vector<GoalEvent> goal_events(const MissionGoals& before, const MissionGoals& now) {
  std::vector<GoalEvent> events;
  if (!before.names.empty()) add_changes(before, now, events);
  for (std::size_t i = before.reached; i < now.reached; ++i)
    events.push_back({"goal_reached", numbered(now, i)});
  if (has_another_next(before, now)) events.push_back({"goal_next", numbered(now, now.reached)});
  return events;
}

}  // namespace aisle
