#pragma once

#include "aisle/commands/convert.hpp"
#include "aisle/simulation/world.hpp"

namespace aisle {

/// The walls of the plan that the options name, with a start if the plan tells one.
Result<World> world_of_plan(const ConvertOptions& options, Console& console);

/// The same with a start and a tour where the plan tells none and a vehicle has room.
struct PlannedWorld {
  World world;
  double drivable_m2 = 0;  ///< where a vehicle can be
};
PlannedWorld with_tour(World world, const RoundTripParams& run, Console& console);

/// Whether there is a file that is a plan: no YAML, or one that names a map_server's image.
bool is_plan(const std::filesystem::path& file);

/// What a file with this content and name is; never kAny.
PlanKind plan_kind_of(const std::filesystem::path& name, std::string_view bytes);

}  // namespace aisle
