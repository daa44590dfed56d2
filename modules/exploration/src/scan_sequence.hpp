#pragma once

#include <array>
#include <optional>

#include "aisle/exploration/grid_rules.hpp"

namespace aisle {

/// The sides in the order in which a crossing is scanned: the first open one is taken, the last becomes the
/// top of the stack. C97's order is left, right, top, bottom whatever the heading; kHoming's is left, ahead,
/// right relative to the vehicle, which makes the way home shortest.
std::array<Side, 4> scan_sequence(GridRuleSet set, std::optional<Side> came_from);

}  // namespace aisle
