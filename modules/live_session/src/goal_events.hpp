#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace aisle {

/// The goals of a mission, in order.
struct MissionGoals {
  std::vector<std::string> names;  ///< "desk", "8.00, 2.00 m" or "8.00, 2.00 m, 90°"
  std::size_t reached = 0;         ///< so many of them, from the first on; at most all

  bool are_left() const { return reached < names.size(); }
};

/// The goals of a message of /goals; nullopt: it is none.
std::optional<MissionGoals> parse_goals(const std::string& goals_json);

struct GoalEvent {
  const char* kind = "";  ///< of docs/reference/live-server.md
  std::string text;
};

/// What happened between two messages: goals that were removed, added and reached, and which is the next.
/// @param before  empty: the mission begins
std::vector<GoalEvent> goal_events(const MissionGoals& before, const MissionGoals& now);

}  // namespace aisle
