#include "floor/wall_floor_edge.hpp"

#include <algorithm>
#include <cmath>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

constexpr double kClearSign = 0.5;  // of the contrast: three quarters step one way

}  // namespace

double WallFloorEdge::slope_deg() const {
  return std::atan2(direction.y(), direction.x()) / kDegree;
}

bool WallFloorEdge::has_clear_sign() const {
  return std::abs(sign) > kClearSign * contrast;
}

/// The evidence of the edges alone.
double WallFloorEdge::support() const {
  return covered * (0.5 + 0.5 * share) * std::min(1.0, contrast / 14 + 0.25);
}

/// Vertical lines end at a wall-floor edge and do not cross it; there is floor beneath it and none above.
double WallFloorEdge::score() const {
  const double floor_points_alone = 0.02 * std::min(floor_points, 4.0) * std::min(1.0, contrast / 14 + 0.25);
  const double standing = (1 + 0.45 * std::min(floor_points, 2.5)) * (floor_points + share + 0.5) /
                          (floor_points + share + crossings + 0.5);
  const double floored = (0.4 + 0.6 * on_floor) * (1 + at_edge);
  return (support() + floor_points_alone) * standing * (1 - 0.7 * followed) * floored;
}

}  // namespace aisle
