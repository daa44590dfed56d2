#pragma once

#include "aisle/commands/simulation_setting.hpp"
#include "aisle/core/progress.hpp"
#include "aisle/core/random.hpp"
#include "aisle/maps/building.hpp"
#include "aisle/simulation/paths/free_floor.hpp"

namespace aisle {

/// The building that the world is: all that the vehicle's scanner can hit, exactly, and the floor that can be
/// reached from its start. Its frame `map` is the world's.
Building building_of_world(const SimulationSetting& setting, const FreeFloor& floor);

/// The same as a map with 5 cm cells that somebody made before 5 % of the walls were built and the furniture
/// was moved.
Result<Building> outdated_map_of_world(const SimulationSetting& setting, const FreeFloor& floor,
                                       Random random, Progress& progress);

}  // namespace aisle
