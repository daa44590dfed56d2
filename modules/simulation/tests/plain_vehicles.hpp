#pragma once

#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

inline VehicleDescription front_steered() {
  VehicleDescription vehicle;
  vehicle.front_steered.wheelbase_m = 0.75;
  return vehicle;
}

inline VehicleDescription two_wheeled() {
  VehicleDescription vehicle;
  vehicle.is_differential = true;
  return vehicle;
}

inline constexpr Footprint kCart{.front_m = 1, .rear_m = 0.2, .width_m = 0.6, .height_m = 1.2};

}  // namespace aisle
