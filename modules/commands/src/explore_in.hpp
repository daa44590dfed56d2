#pragma once

#include <string>

#include "aisle/commands/explore.hpp"
#include "simulation_setting.hpp"

namespace aisle {

/// The vehicle that explores: as asked, else the shipped one with the sensor.
std::string exploring_vehicle(const ExploreOptions& options);

/// `aisle explore` in a setting that was read, or made by chance.
Result<Outcome> explore_in(const ExploreOptions& options, SimulationSetting setting, Console& console);

}  // namespace aisle
