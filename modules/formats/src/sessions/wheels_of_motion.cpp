#include "sessions/wheels_of_motion.hpp"

#include <algorithm>
#include <cmath>

#include "aisle/core/angle.hpp"
#include "aisle/vehicle/arc.hpp"

namespace aisle {
namespace {

constexpr double kWheelStepsMax = 1e9;

/// The arc that leads as far ahead and to the same heading.
Arc arc_ahead(const Pose2& motion) {
  const double turn_rad = wrap_angle(motion.theta), half_turn = turn_rad / 2;
  const double chord_m = Vec2(motion.x, motion.y).dot(unit(half_turn));
  return {half_turn == 0 ? chord_m : chord_m * half_turn / std::sin(half_turn), turn_rad};
}

/// Undoes C99 eq. (1), (2).
FrontSteeredMotion steered_motion(const FrontSteered& vehicle, const Arc& arc) {
  const double lateral_m = arc.turn_rad * vehicle.wheelbase_m;
  const double gear = arc.length_m < 0 ? -1 : 1;
  return {gear * std::hypot(arc.length_m, lateral_m), std::atan2(gear * lateral_m, gear * arc.length_m)};
}

int whole_steps(double distance_m, const Differential& vehicle) {
  return static_cast<int>(
      std::lround(std::clamp(distance_m / vehicle.step_length_m(), -kWheelStepsMax, kWheelStepsMax)));
}

WheelSteps steps_along(const Differential& vehicle, const Arc& arc) {
  const double lead_m = arc.turn_rad * vehicle.wheel_separation_m / 2;
  return {whole_steps(arc.length_m - lead_m, vehicle), whole_steps(arc.length_m + lead_m, vehicle)};
}

}  // namespace

OdometryReading wheels_of(const VehicleDescription& vehicle, const Pose2& motion) {
  const Arc arc = arc_ahead(motion);
  if (vehicle.is_differential) return steps_along(vehicle.differential, arc);
  return steered_motion(vehicle.front_steered, arc);
}

}  // namespace aisle
