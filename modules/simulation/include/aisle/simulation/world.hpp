#pragma once

#include <string>
#include <vector>

#include "aisle/geometry/segment2.hpp"

namespace aisle {

/// A building to drive in: a horizontal cut at the scanner's height, in the frame `world` [m].
///
/// What a camera needs besides (heights, doors, furniture with a top) becomes further lists here; these walls
/// stay what they are.
struct World {
  std::string name;
  std::vector<Segment2>
      walls;               ///< opaque from both sides; the free side is on the left where there is only one
  std::vector<Vec2> tour;  ///< way points that a vehicle drives in this order; may be empty
};

}  // namespace aisle
