#pragma once

#include <optional>
#include <span>

#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// The direction of the walls around a place, where they are at right angles.
struct WallDirection {
  Vec2 p_map = Vec2::Zero();  ///< where they were seen from
  double direction_rad = 0;   ///< in `map`, of one of their two axes: -45 .. 45 degrees
  double sigma_rad = 0;       ///< > 0
};

/// The one observed nearest to a place; nullopt if none is within reach. O(n)
std::optional<WallDirection> walls_around(std::span<const WallDirection> known, const Vec2& p_map,
                                          double reach_m);

}  // namespace aisle
