#include "vehicle.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "pose.hpp"

namespace robots {
namespace {

constexpr double kGround_m = 0.035;  ///< below the hull

std::string driven_wheel(const Vehicle& vehicle, const char* name, double y_m) {
  return fmt::format(R"(
    <body name="{0}" pos="0 {1} {2}">
      <joint name="{0}" axis="0 1 0" damping="0.0005" armature="0.002"/><geom class="wheel"/>
    </body>)",
                     name, y_m, vehicle.wheel_radius_m);
}

std::string steered_wheel(const Vehicle& vehicle, const char* side, double y_m) {
  return fmt::format(R"(
    <body name="{0}_front_wheel" pos="{1} {2} {3}">
      <joint name="{0}_steering" axis="0 0 1" damping="0.4" armature="0.002"/>
      <joint name="{0}_front_wheel" axis="0 1 0" damping="0.0005"/><geom class="wheel"/>
    </body>)",
                     side, vehicle.wheelbase_m, y_m, vehicle.wheel_radius_m);
}

/// With the two wheels it makes three supports: four in a plane would lift a driven wheel.
std::string caster(const Vehicle& vehicle) {
  constexpr double kRadius_m = 0.03, kBehindTheFront_m = 0.08;
  return fmt::format(R"(
    <geom class="caster" pos="{} 0 {}" size="{}"/>)",
                     vehicle.front_m - kBehindTheFront_m, kRadius_m, kRadius_m);
}

std::string wheels(const Vehicle& vehicle) {
  const double y_m = vehicle.wheel_separation_m / 2;
  const std::string driven =
      driven_wheel(vehicle, "left_wheel", y_m) + driven_wheel(vehicle, "right_wheel", -y_m);
  if (!vehicle.is_steered()) return driven + caster(vehicle);
  return driven + steered_wheel(vehicle, "left", y_m) + steered_wheel(vehicle, "right", -y_m);
}

std::string hull(const Vehicle& vehicle) {
  const double half_height_m = (vehicle.laser_z_m - 0.04 - kGround_m) / 2;
  return fmt::format(R"(
    <geom class="hull" name="hull" pos="{0} 0 {1}" size="{2} {3} {4}" mass="{5}"/>
    <geom class="inside" pos="0 0 {1}" size="0.05 0.05 0.02" mass="{6}"/>)",
                     (vehicle.front_m - vehicle.rear_m) / 2, kGround_m + half_height_m,
                     (vehicle.front_m + vehicle.rear_m) / 2, vehicle.width_m / 2, half_height_m,
                     vehicle.hull_mass_kg, vehicle.battery_mass_kg);
}

}  // namespace

Vehicle differential_vehicle() {
  Vehicle vehicle;
  vehicle.drive = "differential";
  return vehicle;
}

Vehicle front_steered_vehicle() {
  Vehicle vehicle;
  vehicle.drive = "front-steered";
  vehicle.wheel_separation_m = 0.22;
  vehicle.wheelbase_m = 0.32;
  vehicle.steering_max_rad = to_radians(35);
  vehicle.steering_rate_max_radps = to_radians(120);
  vehicle.front_m = 0.41;
  vehicle.rear_m = 0.09;
  vehicle.laser_x_m = 0.2;
  vehicle.camera_x_m = 0.36;
  vehicle.speed_max_mps = 1;
  vehicle.motor_torque_max_Nm = 0.35;
  vehicle.hull_mass_kg = 4;
  return vehicle;
}

std::string vehicle_body(const Vehicle& vehicle, const std::string& pose) {
  const std::string sensors = fmt::format(
      R"(
    <site name="laser" pos="{} 0 {}" size="0.02"/>
    <camera name="front" pos="{} 0 {}" xyaxes="0 -1 0 {} 0 {}" fovy="{}"/>)",
      vehicle.laser_x_m, vehicle.laser_z_m, vehicle.camera_x_m, vehicle.camera_z_m,
      std::sin(vehicle.camera_tilt_rad), std::cos(vehicle.camera_tilt_rad),
      to_degrees(vehicle.camera_fovy_rad));
  return fmt::format("\n  <body name=\"base_link\" {}>\n    <freejoint/>", pose) + hull(vehicle) +
         wheels(vehicle) + sensors + "\n  </body>";
}

std::string vehicle_actuators(const Vehicle& vehicle) {
  std::string actuators;
  for (const char* wheel : {"left_wheel", "right_wheel"}) {
    actuators += fmt::format(
        "\n  <velocity name=\"{0}\" joint=\"{0}\" kv=\"0.5\" forcelimited=\"true\" "
        "forcerange=\"-{1} {1}\"/>",
        wheel, vehicle.motor_torque_max_Nm);
  }
  if (!vehicle.is_steered()) return actuators;
  for (const char* steering : {"left_steering", "right_steering"}) {
    actuators += fmt::format(
        "\n  <position name=\"{0}\" joint=\"{0}\" kp=\"20\" forcelimited=\"true\" forcerange=\"-3 3\"/>",
        steering);
  }
  return actuators;
}

nlohmann::json measures_of(const Vehicle& vehicle) {
  nlohmann::json measures = {
      {"drive", vehicle.drive},
      {"wheel_radius_m", vehicle.wheel_radius_m},
      {"wheel_separation_m", vehicle.wheel_separation_m},
      {"footprint",
       {{"front_m", vehicle.front_m},
        {"rear_m", vehicle.rear_m},
        {"width_m", vehicle.width_m},
        {"height_m", vehicle.height_m}}},
      {"speed_max_mps", vehicle.speed_max_mps},
      {"turn_rate_max_radps", vehicle.turn_rate_max_radps},
      {"laser", {{"x_m", vehicle.laser_x_m}, {"y_m", 0}, {"z_m", vehicle.laser_z_m}, {"yaw_deg", 0}}},
      {"camera",
       {{"x_m", vehicle.camera_x_m},
        {"y_m", 0},
        {"z_m", vehicle.camera_z_m},
        {"tilt_deg", to_degrees(vehicle.camera_tilt_rad)}}},
  };
  if (vehicle.is_steered()) {
    measures["wheelbase_m"] = vehicle.wheelbase_m;
    measures["steering_max_deg"] = to_degrees(vehicle.steering_max_rad);
  }
  return measures;
}

}  // namespace robots
