#pragma once

#include "aisle/core/problem.hpp"
#include "aisle/simulation/world.hpp"

namespace aisle {

/// Contradictions between numbers that are each valid: two places of the same name, a poster above the
/// ceiling, a start inside a cupboard. The place of each problem is its key alone: "places[2].name".
Problems contradictions(const World& world);

}  // namespace aisle
