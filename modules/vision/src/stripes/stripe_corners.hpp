#pragma once

#include <span>
#include <vector>

#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// The ends of the straight segments of a polyline, first and last included: the corners are where the
/// lines through neighbouring segments' points meet. A segment's points are within `tolerance` of its chord.
std::vector<Vec2> polyline_corners(std::span<const Vec2> points, double tolerance);

}  // namespace aisle
