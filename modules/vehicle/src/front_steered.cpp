#include "aisle/vehicle/front_steered.hpp"

#include <cmath>

namespace aisle {
namespace {

/// Derivative of the arc's (length, turn) by (S, delta).
Mat2 arc_jacobian(const FrontSteered& vehicle, const FrontSteeredMotion& motion) {
  const double c = std::cos(motion.steering_rad), s = std::sin(motion.steering_rad);
  Mat2 jacobian;
  jacobian << c, -motion.distance_m * s,  //
      s / vehicle.wheelbase_m, motion.distance_m * c / vehicle.wheelbase_m;
  return jacobian;
}

/// Covariance of the reported (S, delta).
Mat2 report_covariance(const FrontSteeredMotion& motion, const FrontSteeredNoise& noise) {
  const double scale_m = noise.distance_scale * motion.distance_m;
  const double slip_m2_per_m = noise.distance_slip_m_per_sqrt_m * noise.distance_slip_m_per_sqrt_m;
  const double rounding_m2 = 2 * noise.distance_quantum_m * noise.distance_quantum_m / 12;  // at both ends
  const double rounding_rad2 = noise.steering_quantum_rad * noise.steering_quantum_rad / 12;
  Mat2 covariance = Mat2::Zero();
  covariance(0, 0) = scale_m * scale_m + slip_m2_per_m * std::abs(motion.distance_m) + rounding_m2;
  covariance(1, 1) = noise.steering_bias_rad * noise.steering_bias_rad + rounding_rad2;
  return covariance;
}

}  // namespace

void FrontSteered::describe(FieldList& fields) {
  fields.real("wheelbase_m", wheelbase_m, {0.01, 10}, "from the rear axle to the front reference point");
}

void FrontSteeredNoise::describe(FieldList& fields) {
  fields.real("distance_scale", distance_scale, {0, 1}, "error of the odometer's scale, as a share");
  fields.real("distance_slip_m_per_sqrt_m", distance_slip_m_per_sqrt_m, {0, 1},
              "error of the distance after one metre, growing with the root of the distance");
  fields.angle(
      "heading_slip_deg_per_sqrt_m", heading_slip_rad_per_sqrt_m, {0, 90},
      "error of the heading after one metre by sideways slip, growing with the root of the distance");
  fields.real("distance_quantum_m", distance_quantum_m, {0, 1}, "distances come in multiples of this");
  fields.angle("steering_bias_deg", steering_bias_rad, {0, 45}, "error of the steering's zero");
  fields.angle("steering_quantum_deg", steering_quantum_rad, {0, 45},
               "steering angles come in multiples of this");
}

Arc arc_of(const FrontSteered& vehicle, const FrontSteeredMotion& motion) {
  return {motion.distance_m * std::cos(motion.steering_rad),
          motion.distance_m * std::sin(motion.steering_rad) / vehicle.wheelbase_m};  // C99 eq. (1), (2)
}

Pose2 drive(const FrontSteered& vehicle, const FrontSteeredMotion& motion) {
  return end_pose(arc_of(vehicle, motion));
}

Mat32 drive_jacobian(const FrontSteered& vehicle, const FrontSteeredMotion& motion) {
  return end_pose_jacobian(arc_of(vehicle, motion)) * arc_jacobian(vehicle, motion);
}

UncertainPose2 drive(const FrontSteered& vehicle, const FrontSteeredMotion& motion,
                     const FrontSteeredNoise& noise) {
  if (motion.distance_m == 0) return {};
  const Mat2 by_report = arc_jacobian(vehicle, motion);
  Mat2 arc_covariance = by_report * report_covariance(motion, noise) * by_report.transpose();
  arc_covariance(1, 1) +=
      noise.heading_slip_rad_per_sqrt_m * noise.heading_slip_rad_per_sqrt_m * std::abs(motion.distance_m);
  const Arc arc = arc_of(vehicle, motion);
  const Mat32 by_arc = end_pose_jacobian(arc);
  return {end_pose(arc), by_arc * arc_covariance * by_arc.transpose()};
}

Pose2 front_pose(const FrontSteered& vehicle, const Pose2& T_frame_vehicle) {
  return T_frame_vehicle * Pose2{vehicle.wheelbase_m, 0, 0};
}

}  // namespace aisle
