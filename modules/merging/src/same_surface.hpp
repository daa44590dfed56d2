#pragma once

#include <cmath>

#include "aisle/maps/occupied_near.hpp"

namespace aisle {

/// Two maps draw one surface apart by this.
inline constexpr double kSameSurface_m = 0.1;

/// Whether the floor has a surface where another map of it shows one.
inline bool has_surface_at(const FloorGrid& floor, FloorCell cell) {
  return is_occupied_near(floor, cell, static_cast<int>(std::lround(kSameSurface_m / floor.cell_m())));
}

}  // namespace aisle
