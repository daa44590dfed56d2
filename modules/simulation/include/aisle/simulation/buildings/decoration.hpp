#pragma once

#include "aisle/core/random.hpp"
#include "aisle/simulation/world.hpp"

namespace aisle {

/// Posters and notice boards on walls with enough space for them, not over doors.
void hang_posters(World& world, Random& random);

/// Decorates bare walls like a corridor: closed doors mounted on the walls along the tour, posters, and lamps
/// above the tour. Nothing is added that a vehicle could hit.
void dress(World& world, Random random);

}  // namespace aisle
