#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "aisle/core/problem.hpp"
#include "live_arguments.hpp"

namespace aisle {

inline constexpr std::size_t kGoalsMax = 100;  ///< of one mission

/// A place's name, "x,y" or "x,y,heading_deg"; empty: nothing of that is there.
std::string goal_in(LiveArguments& arguments);

/// The goal of an item of a list; collects its problems.
/// @param key  of the item
std::string goal_in(const nlohmann::json& item, const std::string& key, Problems& problems);

/// The goals of a list, in order. Collects the problems of each.
std::vector<std::string> goals_in(const nlohmann::json& list, Problems& problems);

}  // namespace aisle
