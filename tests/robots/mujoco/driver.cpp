#include "driver.hpp"

#include <algorithm>
#include <cmath>

namespace robots {
namespace {

constexpr double kCommandAgeMax_s = 0.5;

bool is_finite(const Command& command) {
  return std::isfinite(command.speed_mps) && std::isfinite(command.turn_rate_radps) &&
         std::isfinite(command.steering_rad.value_or(0));
}

}  // namespace

void Driver::take(const Command& command) {
  const bool is_outdated = last_ && command.given_s < last_->given_s;
  if (is_finite(command) && !is_outdated) last_ = command;
}

bool Driver::is_fresh(double now_s) const {
  return last_ && now_s - last_->given_s <= kCommandAgeMax_s;
}

MotorTargets Driver::targets(double now_s, double duration_s) {
  if (!is_fresh(now_s)) last_.reset();
  const Command command = last_.value_or(Command{});
  speed_mps_ = std::clamp(command.speed_mps, -vehicle_.speed_max_mps, vehicle_.speed_max_mps);
  const double turn_mps = turn_rate(command, duration_s) * calibration_.separation_m / 2;
  MotorTargets targets;
  targets.left_wheel_radps = (speed_mps_ - turn_mps) / calibration_.left_radius_m;
  targets.right_wheel_radps = (speed_mps_ + turn_mps) / calibration_.right_radius_m;
  if (vehicle_.is_steered()) {
    // Both front wheels turn about the same point, on the line of the rear axle.
    const double tangent = std::tan(steering_rad_);
    const double half = vehicle_.wheel_separation_m / 2 * tangent;
    targets.left_steering_rad = std::atan2(vehicle_.wheelbase_m * tangent, vehicle_.wheelbase_m - half);
    targets.right_steering_rad = std::atan2(vehicle_.wheelbase_m * tangent, vehicle_.wheelbase_m + half);
  }
  return targets;
}

/// A steered vehicle turns as its front wheels stand; its rear wheels are driven to match.
double Driver::turn_rate(const Command& command, double duration_s) {
  if (!vehicle_.is_steered()) {
    return std::clamp(command.turn_rate_radps, -vehicle_.turn_rate_max_radps, vehicle_.turn_rate_max_radps);
  }
  steer(command, duration_s);
  return speed_mps_ * std::tan(steering_rad_) / vehicle_.wheelbase_m;
}

/// Without speed a turn rate says nothing of the steering, which then stays.
void Driver::steer(const Command& command, double duration_s) {
  double wanted_rad = steering_rad_;
  if (command.steering_rad) {
    wanted_rad = *command.steering_rad;
  } else if (command.speed_mps != 0) {
    wanted_rad = std::atan(vehicle_.wheelbase_m * command.turn_rate_radps / command.speed_mps);
  }
  wanted_rad = std::clamp(wanted_rad, -vehicle_.steering_max_rad, vehicle_.steering_max_rad);
  const double step_rad = vehicle_.steering_rate_max_radps * duration_s;
  steering_rad_ += std::clamp(wanted_rad - steering_rad_, -step_rad, step_rad);
}

}  // namespace robots
