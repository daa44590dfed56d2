#pragma once

#include <optional>
#include <string>
#include <vector>

#include "aisle/core/problem.hpp"
#include "aisle/simulation/world.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// What keeps a vehicle from exploring a world at all, each with its place: it does not fit where it is to
/// start, or the floor leads out of the building. Empty: nothing does.
/// @param world_file  stands for the world in problems
Problems check_explorable(const World& world, const std::string& world_file,
                          const VehicleDescription& vehicle, const Pose2& T_world_start);

/// Where a vehicle that keeps a distance from obstacles comes out of the building; nullopt: nowhere.
std::optional<Vec2> opening_of(const World& world, const VehicleDescription& vehicle,
                               const Vec2& p_world_start);

}  // namespace aisle
