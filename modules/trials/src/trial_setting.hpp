#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "aisle/commands/simulation_setting.hpp"
#include "aisle/trials/trial_options.hpp"

namespace aisle {

/// The setting of a seed's mission: one of the given worlds, in turn, or a random building.
/// @param kinds  of random buildings, taken in turn unless the options ask for one kind
Result<SimulationSetting> setting_of_seed(const TrialOptions& options, std::uint64_t seed,
                                          const std::string& vehicle, std::span<const BuildingKind> kinds);

}  // namespace aisle
