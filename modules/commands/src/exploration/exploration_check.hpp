#pragma once

#include <optional>
#include <string>
#include <vector>

#include "aisle/core/problem.hpp"
#include "aisle/simulation/world.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// Why a vehicle cannot explore a world at all: it does not fit at its start, or the floor leads out of the
/// building. Empty: it can.
/// @param world_file  names the world in problems
Problems check_explorable(const World& world, const std::string& world_file,
                          const VehicleDescription& vehicle, const Pose2& T_world_start);

/// Where a vehicle that keeps clear of obstacles could leave the building; nullopt: nowhere.
std::optional<Vec2> opening_of(const World& world, const VehicleDescription& vehicle,
                               const Vec2& p_world_start);

}  // namespace aisle
