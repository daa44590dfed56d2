#include "live_goals.hpp"

#include <fmt/format.h>

namespace aisle {

std::string goal_in(LiveArguments& arguments) {
  std::string place = arguments.text("place");
  const auto x = arguments.number("x_m"), y = arguments.number("y_m");
  const auto heading_deg = arguments.number("heading_deg");
  if (!place.empty() || !x || !y) return place;
  const std::string at = fmt::format("{:.3f},{:.3f}", *x, *y);
  return heading_deg ? fmt::format("{},{:.1f}", at, *heading_deg) : at;
}

std::string goal_in(const nlohmann::json& item, const std::string& key, Problems& problems) {
  if (!item.is_object()) {
    problems.push_back({{"", 0, key}, "must be an object"});
    return {};
  }
  LiveArguments arguments(item);
  std::string goal = goal_in(arguments);
  for (const Problem& problem : arguments.problems())
    problems.push_back({{"", 0, key + "." + problem.where.key}, problem.what});
  if (goal.empty()) problems.push_back({{"", 0, key}, "has neither place nor x_m and y_m"});
  return goal;
}

std::vector<std::string> goals_in(const nlohmann::json& list, Problems& problems) {
  std::vector<std::string> goals;
  if (!list.is_array() || list.size() > kGoalsMax) {
    problems.push_back({{"", 0, "goals"}, fmt::format("must be a list of at most {}", kGoalsMax)});
    return goals;
  }
  for (const nlohmann::json& item : list)
    goals.push_back(goal_in(item, fmt::format("goals.{}", goals.size() + 1), problems));
  return goals;
}

}  // namespace aisle
