#pragma once

#include "aisle/commands/convert.hpp"
#include "aisle/simulation/world.hpp"

namespace aisle {

/// World with the walls of the plan that the options name, and with a start if the plan has one.
Result<World> world_of_plan(const ConvertOptions& options, Console& console);

/// A world with a start and a tour, if there is room for a vehicle.
struct PlannedWorld {
  World world;
  double drivable_m2 = 0;  ///< floor where a vehicle fits
};
PlannedWorld with_tour(World world, const RoundTripParams& run, Console& console);

/// Whether the file exists and is a plan: no YAML, or a map_server YAML that names an image.
bool is_plan(const std::filesystem::path& file);

/// Detects the kind of a plan from its content and name; never kAny.
PlanKind plan_kind_of(const std::filesystem::path& name, std::string_view bytes);

}  // namespace aisle
