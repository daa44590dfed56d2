#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "aisle/commands/trial.hpp"
#include "simulation_setting.hpp"

namespace aisle {

/// What the mission of a seed happens in: one of the worlds that were given, in turn, or a building by
/// chance.
/// @param kinds  of buildings by chance, taken in turn unless one kind is asked for
Result<SimulationSetting> setting_of_seed(const TrialOptions& options, std::uint64_t seed,
                                          const std::string& vehicle, std::span<const BuildingKind> kinds);

}  // namespace aisle
