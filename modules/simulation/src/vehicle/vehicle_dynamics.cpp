#include "aisle/simulation/vehicle/vehicle_dynamics.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {
namespace {

double approach(double value, double wanted, double change_max) {
  return value + std::clamp(wanted - value, -change_max, change_max);
}

/// Brakes to standstill before it changes direction.
double next_speed_mps(double speed_mps, double wanted_mps, const DriveLimits& limits, double time_s) {
  const bool turns_round = speed_mps * wanted_mps < 0;
  const double target_mps = turns_round ? 0 : wanted_mps;
  const bool brakes = std::abs(target_mps) < std::abs(speed_mps);
  const double change_mps2 = brakes ? limits.deceleration_max_mps2 : limits.acceleration_max_mps2;
  return approach(speed_mps, target_mps, change_mps2 * time_s);
}

}  // namespace

Arc arc_of(const VehicleDescription& vehicle, const Travel& travel, double steering_bias_rad) {
  if (vehicle.is_differential) return {travel.distance_m, travel.turn_rad};
  return arc_of(vehicle.front_steered, {travel.distance_m, travel.steering_rad + steering_bias_rad});
}

Travel operator*(double share, const Travel& travel) {
  return {share * travel.distance_m, travel.steering_rad, share * travel.turn_rad};
}

Travel VehicleDynamics::step(const Command& wanted, double time_s) {
  const DriveLimits& limits = vehicle_.limits;
  const Command before = state_;
  const double speed_mps = std::clamp(wanted.speed_mps, -limits.reverse_speed_max_mps, limits.speed_max_mps);
  state_.speed_mps = next_speed_mps(before.speed_mps, speed_mps, limits, time_s);
  const double distance_m = (before.speed_mps + state_.speed_mps) / 2 * time_s;
  if (vehicle_.is_differential) {
    const double turn_rate_rad_s =
        std::clamp(wanted.turn_rate_rad_s, -limits.turn_rate_max_rad_s, limits.turn_rate_max_rad_s);
    state_.turn_rate_rad_s =
        approach(before.turn_rate_rad_s, turn_rate_rad_s, limits.turn_acceleration_max_rad_s2 * time_s);
    return {.distance_m = distance_m,
            .turn_rad = (before.turn_rate_rad_s + state_.turn_rate_rad_s) / 2 * time_s};
  }
  const double steering_rad =
      std::clamp(wanted.steering_rad, -limits.steering_max_rad, limits.steering_max_rad);
  state_.steering_rad = approach(before.steering_rad, steering_rad, limits.steering_rate_max_rad_s * time_s);
  return {.distance_m = distance_m, .steering_rad = (before.steering_rad + state_.steering_rad) / 2};
}

void VehicleDynamics::halt() {
  state_.speed_mps = 0;
  state_.turn_rate_rad_s = 0;
}

}  // namespace aisle
