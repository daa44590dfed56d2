#pragma once

#include <string>

#include "aisle/maps/wall_map.hpp"

namespace aisle {

/// Everything that was learned of one building. Every part may be empty.
struct Building {
  std::string name;
  bool has_dominant_direction = false;  ///< most walls lie on one orthogonal frame, the axes of `map`
  WallMap walls;
};

}  // namespace aisle
