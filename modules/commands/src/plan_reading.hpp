#pragma once

#include "aisle/commands/convert.hpp"
#include "aisle/simulation/world.hpp"

namespace aisle {

/// The walls of the plan that the options name, with a start if the plan tells one.
Result<World> world_of_plan(const ConvertOptions& options, Console& console);

/// What a file with this content and name is; never kAny.
PlanKind plan_kind_of(const std::filesystem::path& name, std::string_view bytes);

}  // namespace aisle
