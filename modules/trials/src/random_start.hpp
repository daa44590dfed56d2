#pragma once

#include <cstdint>

#include "aisle/commands/simulation_setting.hpp"

namespace aisle {

/// A random pose on floor that the vehicle can reach from the world's start, with 15 cm of space on all
/// sides.
/// @param ahead_m  space before its front, at least 0.15
/// @return the world's start if no such pose is found; a problem if the world has no start
Result<Pose2> random_start(const SimulationSetting& setting, double ahead_m, std::uint64_t seed);

}  // namespace aisle
