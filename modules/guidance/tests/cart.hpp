#pragma once

#include "aisle/core/angle.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

inline VehicleDescription cart() {
  VehicleDescription vehicle;
  vehicle.front_steered.wheelbase_m = 0.75;
  vehicle.footprint = {.front_m = 0.95, .rear_m = 0.25, .width_m = 0.6, .height_m = 1.3};
  return vehicle;
}

/// Of the cart, at its front.
inline constexpr LaserScanner kGeometry{-90 * kDegree, 1 * kDegree, 30, {0.9, 0, 0}};

}  // namespace aisle
