#pragma once

#include "aisle/core/random.hpp"
#include "aisle/simulation/world.hpp"

namespace aisle {

/// A room of dark furniture with one turning (docs/reference/turnings.md) between aisles, and a route
/// through it.
/// @param number  1 to 13
World turning_course(int number, Random& random);

/// A room with two turnings to one side that are closer together than a vehicle can turn (L96 section 3.3):
/// out of an aisle into one across, and at once out of that into the aisle next to the first. Its route
/// reverses between them.
/// @param first, second  6 and 5 (to the right), or 8 and 7 (to the left)
World close_turnings_course(int first, int second, Random& random);

}  // namespace aisle
