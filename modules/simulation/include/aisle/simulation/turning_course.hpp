#pragma once

#include "aisle/core/random.hpp"
#include "aisle/simulation/world.hpp"

namespace aisle {

/// A room of dark furniture with one turning (METHODS 9) between aisles, and a route through it.
/// @param number  1 to 13
World turning_course(int number, Random& random);

}  // namespace aisle
