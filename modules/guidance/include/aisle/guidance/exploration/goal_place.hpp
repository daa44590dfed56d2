#pragma once

#include <cstddef>
#include <optional>

#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// Where a vehicle is to drive, and how it is to stand there.
struct GoalPlace {
  Vec2 p_map = Vec2::Zero();
  std::optional<double> heading_rad = {};  ///< none: it does not matter
};

/// How the vehicle stood at a goal that has a heading.
struct GoalHeading {
  std::size_t place = 0;  ///< index of the goal
  double off_rad = 0;     ///< from its heading to the vehicle's, within +-pi
  bool is_reached = false;
};

}  // namespace aisle
