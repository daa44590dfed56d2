#pragma once

#include <nlohmann/json.hpp>

#include "aisle/core/result.hpp"

namespace aisle {

/// The service maze/run: every learning cycle of a run through a maze, see docs/reference/live-server.md.
Result<nlohmann::ordered_json> maze_steps(const nlohmann::json& arguments);

}  // namespace aisle
