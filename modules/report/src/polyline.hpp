#pragma once

#include <vector>

#include "aisle/control/path.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// The polyline with as few points as keep it within `tolerance` everywhere (Douglas and Peucker).
std::vector<Vec2> simplified(const std::vector<Vec2>& points, double tolerance);

/// Points along a path, every 5 cm and at both ends of each piece.
std::vector<Vec2> points_on(const Path& path);

}  // namespace aisle
