#pragma once

#include "aisle/exploration/grid_rules.hpp"

namespace aisle {

/// Marks the rules to which some world leads.
void mark_reachable_rules(GridRules& rules);

}  // namespace aisle
