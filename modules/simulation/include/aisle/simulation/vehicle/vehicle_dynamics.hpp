#pragma once

#include "aisle/vehicle/arc.hpp"
#include "aisle/vehicle/command.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// What a vehicle's wheels do in a time step.
struct Travel {
  double distance_m = 0;    ///< front-steered: of the front reference point; differential: of base_link
  double steering_rad = 0;  ///< front-steered: as its encoder sees it
  double turn_rad = 0;      ///< differential
};

/// The arc that base_link drives.
/// @param steering_bias_rad  front-steered: the wheels really point this much farther left than encoded
Arc arc_of(const VehicleDescription& vehicle, const Travel& travel, double steering_bias_rad = 0);

/// The same motion for only this share of the time.
Travel operator*(double share, const Travel& travel);

/// Speed and steering follow commands as fast as the vehicle's limits allow.
class VehicleDynamics {
 public:
  explicit VehicleDynamics(const VehicleDescription& vehicle) : vehicle_(vehicle) {}

  /// Speed and steering change linearly within the step, so that its arc is exact.
  Travel step(const Command& wanted, double time_s);

  /// Stops at once, as at a wall. The steering is kept.
  void halt();

  /// The present speed and steering, in the units of a command.
  const Command& state() const { return state_; }

 private:
  VehicleDescription vehicle_;
  Command state_;
};

}  // namespace aisle
