#pragma once

#include <vector>

#include "aisle/geometry/segment2.hpp"

namespace aisle {

/// For walls from a plan without sides: turns each wall so that the side with more free space, up to the next
/// wall, is on its left. If both sides have the same, the wall is unchanged.
std::vector<Segment2> with_free_sides_left(const std::vector<Segment2>& walls);

}  // namespace aisle
