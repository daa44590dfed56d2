#pragma once

#include "aisle/core/angle.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/core/random.hpp"
#include "aisle/simulation/vehicle/vehicle_dynamics.hpp"
#include "aisle/vehicle/observation.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// Errors of a simulated vehicle's wheels and encoders. The defaults are an ordinary indoor vehicle.
struct WheelErrors {
  double distance_scale = 0.01;
  double distance_slip_m_per_sqrt_m = 0.003;
  double heading_slip_rad_per_sqrt_m = 0.2 * kDegree;
  double steering_bias_rad = 0.2 * kDegree;     ///< front-steered
  double distance_quantum_m = 0.001;            ///< front-steered
  double steering_quantum_rad = 0.1 * kDegree;  ///< front-steered
  double wheel_difference = 0.005;              ///< differential

  void describe(FieldList& fields);
};

/// Wheels and steering without errors, read exactly.
inline constexpr WheelErrors kPerfectWheels{0, 0, 0, 0, 0, 0, 0};

/// Counts a vehicle's motion as its encoders do: with errors, in whole quanta, with nothing lost between
/// readings.
class WheelOdometry {
 public:
  WheelOdometry(const VehicleDescription& vehicle, const WheelErrors& errors, Random random);

  /// @param spin  share of the distance by which the wheels have turned too far
  void count(const Travel& travel, double spin = 0);

  /// What was counted since the last reading.
  OdometryReading read();

 private:
  FrontSteeredMotion read_motion();
  WheelSteps read_steps();
  double counted_distance_m(double distance_m, double scale, double spin);

  VehicleDescription vehicle_;
  WheelErrors errors_;
  Random random_;
  // Front-steered: distance of the front reference point; the steering is averaged over it.
  double distance_m_ = 0, distance_read_m_ = 0;
  double steering_by_distance_ = 0, travelled_m_ = 0, steering_rad_ = 0;
  // Differential: distances of the wheels, and their steps as read.
  double left_m_ = 0, right_m_ = 0;
  long left_read_ = 0, right_read_ = 0;
};

}  // namespace aisle
