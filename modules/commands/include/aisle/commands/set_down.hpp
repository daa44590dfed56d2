#pragma once
/// Random initial poses, as of a vehicle that is put down by hand; the exact pose if the random one is
/// occupied.

#include <cstdint>
#include <optional>

#include "aisle/commands/driven_vehicle.hpp"
#include "aisle/commands/simulation_setting.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

Pose2 set_down(const SimulationSetting& setting, const UncertainPose2& T_world_start, std::uint64_t seed);

/// At the start of a route that is driven by landmarks.
Pose2 set_down_for_landmarks(const SimulationSetting& setting, const Pose2& T_world_start,
                             std::uint64_t seed);
/// At the start of a route of sections, or of one through a room.
Pose2 set_down_on_route(const SimulationSetting& setting, const Pose2& T_world_start, std::uint64_t seed);
/// At home, before a mission to places in an explored building.
Pose2 set_down_at_home(const SimulationSetting& setting, const Pose2& T_world_home, std::uint64_t seed);
/// Sets a simulated vehicle down at home, or exactly where `--start` says; a robot stands where it stands.
/// @return what hinders: a world without a start, a place where the vehicle does not fit
Problems set_down_at_home_or(const std::optional<Pose2>& T_world_start, DrivenVehicle& driven,
                             std::uint64_t seed);

}  // namespace aisle
