#pragma once

#include <cstdint>

#include "aisle/commands/simulation_setting.hpp"

namespace aisle {

/// A random pose on floor that the vehicle can reach from the world's start, with 15 cm of space on all
/// sides.
/// @param ahead_m  space before its front, at least 0.15
/// @return a problem if no such pose is found, or if the vehicle cannot start at the world's start
Result<Pose2> random_start(const SimulationSetting& setting, double ahead_m, std::uint64_t seed);

}  // namespace aisle
