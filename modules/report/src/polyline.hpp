#pragma once

#include <vector>

#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// The polyline with as few points as keep it within `tolerance` everywhere (Douglas and Peucker).
std::vector<Vec2> simplified(const std::vector<Vec2>& points, double tolerance);

}  // namespace aisle
