#pragma once

#include <span>

#include "aisle/core/parameters.hpp"
#include "aisle/vehicle/gear.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

struct FreeSteeringParams {
  double reach_m = 1.5;
  double margin_m = 0.06;
  double comfort_m = 0.3;
  double step_rad = 2 * kDegree;
  double requested_rad = 20 * kDegree;
  double clearance_weight = 3;
  double reach_weight = 4;

  void describe(FieldList& fields);
};

/// A steering angle and its outcome.
struct SteeringChoice {
  double steering_rad = 0;
  double free_m = 0;  ///< path of base_link until something comes nearer than the margin; at most the reach
  double clearance_m = 0;  ///< smallest clearance on that path
};

/// How far a front-steered vehicle gets with a constant steering angle.
/// @param p_vehicle  obstacle points around it, in base_link
SteeringChoice free_path(const VehicleDescription& vehicle, const FreeSteeringParams& params,
                         std::span<const Vec2> p_vehicle, double steering_rad, Gear gear);

/// The best compromise between a steering angle near the requested one, a long free path, and clearance.
/// @param p_vehicle  obstacle points around it, in base_link
SteeringChoice choose_steering(const VehicleDescription& vehicle, const FreeSteeringParams& params,
                               std::span<const Vec2> p_vehicle, double requested_rad,
                               Gear gear = Gear::kForward);

}  // namespace aisle
