#include "aisle/vehicle/differential.hpp"

#include <cmath>

namespace aisle {
namespace {

/// Derivative of the arc's (length, turn) by the distances of the wheels (left, right).
Mat2 arc_jacobian(const Differential& vehicle) {
  Mat2 jacobian;
  jacobian << 0.5, 0.5,  //
      -1 / vehicle.wheel_separation_m, 1 / vehicle.wheel_separation_m;
  return jacobian;
}

double wheel_variance_m2(const Differential& vehicle, int steps, const DifferentialNoise& noise) {
  if (steps == 0) return 0;
  const double step_m = vehicle.step_length_m(), distance_m = steps * step_m;
  const double scale_m = noise.wheel_scale * distance_m;
  const double slip_m2_per_m = noise.wheel_slip_m_per_sqrt_m * noise.wheel_slip_m_per_sqrt_m;
  const double rounding_m2 = 2 * step_m * step_m / 12;  // at both ends
  return scale_m * scale_m + slip_m2_per_m * std::abs(distance_m) + rounding_m2;
}

}  // namespace

void Differential::describe(FieldList& fields) {
  fields.count("steps_per_turn", steps_per_turn, {1, 1e6}, "motor steps of a full turn of a wheel");
  fields.real("wheel_radius_m", wheel_radius_m, {0.001, 1}, "radius of the driven wheels");
  fields.real("wheel_separation_m", wheel_separation_m, {0.01, 5},
              "between the driven wheels' contact points");
  fields.angle("turn_quantum_deg", turn_quantum_rad, {0.01, 90},
               "turns are commanded and recorded in multiples of this");
}

void DifferentialNoise::describe(FieldList& fields) {
  fields.real("wheel_scale", wheel_scale, {0, 1}, "error of a wheel's radius, as a share");
  fields.real("wheel_slip_m_per_sqrt_m", wheel_slip_m_per_sqrt_m, {0, 1},
              "error of a wheel's distance after one metre, growing with the root of the distance");
  fields.real("separation_scale", separation_scale, {0, 1}, "error of the wheels' separation, as a share");
}

Arc arc_of(const Differential& vehicle, const WheelSteps& steps) {
  const double left_m = steps.left * vehicle.step_length_m(), right_m = steps.right * vehicle.step_length_m();
  return {(left_m + right_m) / 2, (right_m - left_m) / vehicle.wheel_separation_m};
}

Pose2 drive(const Differential& vehicle, const WheelSteps& steps) {
  return end_pose(arc_of(vehicle, steps));
}

Mat32 drive_jacobian(const Differential& vehicle, const WheelSteps& steps) {
  return end_pose_jacobian(arc_of(vehicle, steps)) * arc_jacobian(vehicle);
}

UncertainPose2 drive(const Differential& vehicle, const WheelSteps& steps, const DifferentialNoise& noise) {
  const Vec2 wheel_variances_m2{wheel_variance_m2(vehicle, steps.left, noise),
                                wheel_variance_m2(vehicle, steps.right, noise)};
  const Mat2 by_wheels = arc_jacobian(vehicle);
  Mat2 arc_covariance = by_wheels * wheel_variances_m2.asDiagonal() * by_wheels.transpose();
  const Arc arc = arc_of(vehicle, steps);
  const double turn_scale_rad = noise.separation_scale * arc.turn_rad;
  arc_covariance(1, 1) += turn_scale_rad * turn_scale_rad;
  const Mat32 by_arc = end_pose_jacobian(arc);
  return {end_pose(arc), by_arc * arc_covariance * by_arc.transpose()};
}

WheelSteps turn_on_the_spot(const Differential& vehicle, int quanta) {
  const double distance_m = quanta * vehicle.turn_quantum_rad * vehicle.wheel_separation_m / 2;
  const int steps = static_cast<int>(std::lround(distance_m / vehicle.step_length_m()));
  return {-steps, steps};
}

}  // namespace aisle
