#include "odometry_reading.hpp"

#include <cmath>

#include "aisle/vehicle/arc.hpp"
#include "aisle/vehicle/odometry_step.hpp"

namespace aisle {
namespace {

constexpr double kFineStep_m = 50e-6;
constexpr double kStanding_m = 1e-6;

/// The arc from the origin to a pose: `end_pose` undone, for the part of the pose that lies on an arc.
Arc arc_to(const Pose2& T) {
  const double half_rad = T.theta / 2;
  const double bulge = std::abs(half_rad) < 1e-6 ? 1 : half_rad / std::sin(half_rad);
  return {bulge * T.position().dot(unit(half_rad)), T.theta};
}

WheelSteps wheel_steps(const Arc& arc, const Differential& wheels) {
  const double across_m = arc.turn_rad * wheels.wheel_separation_m / 2;
  const auto steps = [&](double m) { return static_cast<int>(std::lround(m / wheels.step_length_m())); };
  return {steps(arc.length_m - across_m), steps(arc.length_m + across_m)};
}

/// C98 eq. (8): the front reference point goes along its own arc, of a radius that the steering gives.
FrontSteeredMotion front_motion(const Arc& arc, double wheelbase_m, double steering_rad) {
  const double across_m = wheelbase_m * arc.turn_rad;
  const double distance_m = std::hypot(arc.length_m, across_m);
  if (distance_m < kStanding_m) return {0, steering_rad};
  const double gear = arc.length_m < 0 ? -1 : 1;
  return {gear * distance_m, std::atan2(gear * across_m, std::abs(arc.length_m))};
}

}  // namespace

void make_steps_fine(Differential& differential) {
  differential.steps_per_turn =
      static_cast<int>(std::ceil(2 * kPi * differential.wheel_radius_m / kFineStep_m));
}

OdometryReading OdometryReadings::read(const Pose2& T_odom_vehicle, double steering_rad) {
  const Arc arc = arc_to(between(T_odom_read_, T_odom_vehicle));
  const OdometryReading reading = vehicle_.is_differential
                                      ? OdometryReading(wheel_steps(arc, vehicle_.differential))
                                      : front_motion(arc, vehicle_.front_steered.wheelbase_m, steering_rad);
  T_odom_read_ = T_odom_read_ * odometry_step(vehicle_, reading);
  return reading;
}

}  // namespace aisle
