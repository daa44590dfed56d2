#pragma once

#include <vector>

#include "aisle/geometry/segment2.hpp"

namespace aisle {

/// For walls from a plan that tells no sides: each wall turned such that the side with more room, up to the
/// next wall, is on its left. Where both have the same, it stays as it is.
std::vector<Segment2> with_free_sides_left(const std::vector<Segment2>& walls);

}  // namespace aisle
