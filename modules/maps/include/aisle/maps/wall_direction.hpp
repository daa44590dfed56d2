#pragma once

#include <optional>
#include <span>

#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// Which way the walls around a place run, where they stand at right angles.
struct WallDirection {
  Vec2 p_map = Vec2::Zero();  ///< from where they were seen
  double direction_rad = 0;   ///< in `map`, of one of their two axes: -45 .. 45 degrees
  double sigma_rad = 0;       ///< > 0
};

/// What is known from nearest to a place; nullopt: nothing from within reach. O(n)
std::optional<WallDirection> walls_around(std::span<const WallDirection> known, const Vec2& p_map,
                                          double reach_m);

}  // namespace aisle
