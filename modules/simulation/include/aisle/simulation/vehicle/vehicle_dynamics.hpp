#pragma once

#include "aisle/vehicle/arc.hpp"
#include "aisle/vehicle/command.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// What a vehicle's wheels do in a short time.
struct Travel {
  double distance_m = 0;    ///< front-steered: of the front reference point; differential: of base_link
  double steering_rad = 0;  ///< front-steered: as its encoder sees it
  double turn_rad = 0;      ///< differential
};

/// The path of base_link.
/// @param steering_bias_rad  front-steered: how far left of what the encoder sees the wheels really stand
Arc arc_of(const VehicleDescription& vehicle, const Travel& travel, double steering_bias_rad = 0);

/// The same wheels, but only for this share of the time.
Travel operator*(double share, const Travel& travel);

/// Speed and steering that follow commands as fast as the vehicle's limits allow.
class VehicleDynamics {
 public:
  explicit VehicleDynamics(const VehicleDescription& vehicle) : vehicle_(vehicle) {}

  /// Speed and steering change evenly within the step, so that its path is exact.
  Travel step(const Command& wanted, double time_s);

  /// Stands at once, as against a wall. The steering stays.
  void halt();

  /// What it does now, in the units of a command.
  const Command& state() const { return state_; }

 private:
  VehicleDescription vehicle_;
  Command state_;
};

}  // namespace aisle
