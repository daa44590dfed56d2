#pragma once

#include "aisle/core/random.hpp"
#include "aisle/simulation/world.hpp"
#include "buildings/building_layout.hpp"

namespace aisle {

/// Doors in the doorways: closed, or opened into their rooms far enough for a vehicle to pass.
void hang_doors(World& world, const BuildingLayout& layout, Random& random);

/// Tables with chairs, cupboards and pillars in rooms, halls and alcoves; corridors and the passages through
/// doorways stay free.
void furnish(World& world, const BuildingLayout& layout, Random& random);

/// Lamps in rooms, halls and along corridors.
void hang_lamps(World& world, const BuildingLayout& layout, Random& random);

}  // namespace aisle
