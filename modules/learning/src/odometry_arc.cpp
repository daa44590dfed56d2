#include "odometry_arc.hpp"

#include <cmath>

#include "aisle/core/square.hpp"

namespace aisle {
namespace {

UncertainArc arc_read(const VehicleDescription& vehicle, const FrontSteeredMotion& motion) {
  const FrontSteeredNoise& noise = vehicle.front_steered_noise;
  const double path_m = std::abs(motion.distance_m);
  UncertainArc result{arc_of(vehicle.front_steered, motion)};
  if (path_m == 0) return result;
  const double path_m2 =
      square(noise.distance_slip_m_per_sqrt_m) * path_m + square(noise.distance_quantum_m) / 6;
  const double steering_rad2 = square(noise.steering_quantum_rad) / 12;
  const Vec2 by_distance{std::cos(motion.steering_rad),
                         std::sin(motion.steering_rad) / vehicle.front_steered.wheelbase_m};
  result.covariance = by_distance * path_m2 * by_distance.transpose();
  result.covariance(1, 1) += square(noise.heading_slip_rad_per_sqrt_m) * path_m +
                             square(path_m / vehicle.front_steered.wheelbase_m) * steering_rad2;
  return result;
}

UncertainArc arc_read(const VehicleDescription& vehicle, const WheelSteps& steps) {
  const double step_m = vehicle.differential.step_length_m();
  const double slip_m2_per_m = square(vehicle.differential_noise.wheel_slip_m_per_sqrt_m);
  const auto variance_m2 = [&](int wheel_steps) {
    return wheel_steps == 0 ? 0 : slip_m2_per_m * std::abs(wheel_steps * step_m) + square(step_m) / 6;
  };
  const double left_m2 = variance_m2(steps.left), right_m2 = variance_m2(steps.right);
  const double separation_m = vehicle.differential.wheel_separation_m;
  UncertainArc result{arc_of(vehicle.differential, steps)};
  result.covariance << (left_m2 + right_m2) / 4, (right_m2 - left_m2) / (2 * separation_m),
      (right_m2 - left_m2) / (2 * separation_m), (left_m2 + right_m2) / square(separation_m);
  return result;
}

}  // namespace

UncertainArc uncertain_arc(const VehicleDescription& vehicle, const OdometryReading& reading) {
  return std::visit([&](const auto& motion) { return arc_read(vehicle, motion); }, reading);
}

Vec3 steady_odometry_sigmas(const VehicleDescription& vehicle) {
  if (vehicle.is_differential) {
    const DifferentialNoise& noise = vehicle.differential_noise;
    return {noise.wheel_scale / std::sqrt(2), noise.separation_scale,
            noise.wheel_scale * std::sqrt(2) / vehicle.differential.wheel_separation_m};
  }
  const FrontSteeredNoise& noise = vehicle.front_steered_noise;
  return {noise.distance_scale, noise.distance_scale,
          noise.steering_bias_rad / vehicle.front_steered.wheelbase_m};
}

}  // namespace aisle
