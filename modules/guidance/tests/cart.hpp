#pragma once

#include <gtest/gtest.h>

#include <string>

#include "aisle/core/angle.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

inline VehicleDescription cart() {
  VehicleDescription vehicle;
  vehicle.front_steered.wheelbase_m = 0.75;
  vehicle.footprint = {.front_m = 0.95, .rear_m = 0.25, .width_m = 0.6, .height_m = 1.3};
  return vehicle;
}

/// The cart's body on two driven wheels.
inline VehicleDescription differential_cart() {
  VehicleDescription vehicle = cart();
  vehicle.is_differential = true;
  return vehicle;
}

/// For tests of what either drive must do: the parameter is whether the vehicle is differential.
inline VehicleDescription cart_of(bool is_differential) {
  return is_differential ? differential_cart() : cart();
}
inline std::string name_of_drive(const testing::TestParamInfo<bool>& is_differential) {
  return is_differential.param ? "Differential" : "FrontSteered";
}

/// Of the cart, at its front.
inline constexpr LaserScanner kGeometry{-90 * kDegree, 1 * kDegree, 30, {0.9, 0, 0}};

}  // namespace aisle
