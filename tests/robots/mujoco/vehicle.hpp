#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace robots {

/// The true measures of a vehicle. Its origin, base_link, is on the floor below the middle of the driven
/// axle: x forward, y left, z up.
struct Vehicle {
  std::string drive;             ///< "differential" or "front-steered"
  double wheel_radius_m = 0.05;  ///< of all wheels
  double wheel_separation_m = 0.26;
  double wheelbase_m = 0;  ///< 0: no steered wheels, but a caster ahead
  double steering_max_rad = 0;
  double steering_rate_max_radps = 0;

  double front_m = 0.25;  ///< from base_link to where the hull ends
  double rear_m = 0.1;
  double width_m = 0.3;
  double height_m = 0.22;

  double laser_x_m = 0.08;
  double laser_z_m = 0.2;
  double camera_x_m = 0.2;
  double camera_z_m = 0.21;
  double camera_tilt_rad = 0.08;  ///< downwards
  double camera_fovy_rad = 0.85;  ///< from the upper edge of the image to the lower

  double speed_max_mps = 0.5;
  double turn_rate_max_radps = 2;
  double motor_torque_max_Nm = 0.27;  ///< of each driven wheel: sets the acceleration, about 1.5 m/s^2
  double hull_mass_kg = 3;
  double battery_mass_kg = 2;  ///< above the driven axle, for grip

  bool is_steered() const { return wheelbase_m > 0; }
};

Vehicle differential_vehicle();
Vehicle front_steered_vehicle();

/// The vehicle's body, its site `laser` and its camera `front`, for the world of an MJCF model.
/// @param pose attributes of the body: where it starts
std::string vehicle_body(const Vehicle& vehicle, const std::string& pose);
/// The motors: `left_wheel`, `right_wheel` [rad/s] and, if there is steering, `left_steering`,
/// `right_steering` [rad].
std::string vehicle_actuators(const Vehicle& vehicle);

/// What a vehicle file needs to know.
nlohmann::json measures_of(const Vehicle& vehicle);

}  // namespace robots
