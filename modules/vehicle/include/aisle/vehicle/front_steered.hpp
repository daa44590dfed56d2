#pragma once
/// A vehicle that is driven and steered by its front wheels (C98 eq. (8)-(13), C99 eq. (1)-(6)).
///
/// The papers measure steering to the right and give positions in their VCS (x right, y forward, origin
/// between the front wheels); here left is positive and base_link is the rear-axle midpoint:
/// docs/reference/frames.md.
/// C98 eq. (13) and C99 eq. (6) print the rear wheels at x_B + d sin(gamma). That is a misprint for
/// x_B - d sin(gamma): as printed, a vehicle that turned right would point to the left, and its rear would
/// leave its circle about the turning centre.

#include "aisle/core/angle.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/geometry/pose2.hpp"
#include "aisle/vehicle/arc.hpp"

namespace aisle {

struct FrontSteered {
  double wheelbase_m = 0.5;  ///< the papers' d, from the rear axle to the front reference point; > 0

  void describe(FieldList& fields);
};

/// One motion with the steering held still: what the odometer and the steering encoder report of it.
struct FrontSteeredMotion {
  double distance_m = 0;    ///< S, of the front reference point along ITS arc; backwards: negative
  double steering_rad = 0;  ///< delta, left positive, within +-90 degrees
};

/// How far the reported motion may be from the real one: standard deviations. Scale and bias are the same for
/// every motion of a run: adding up many motions as if they were independent gives too small a covariance.
struct FrontSteeredNoise {
  double distance_scale = 0.01;
  double distance_slip_m_per_sqrt_m = 0.005;
  double heading_slip_rad_per_sqrt_m = 0.5 * kDegree;
  double distance_quantum_m = 0.001;
  double steering_bias_rad = 0.5 * kDegree;
  double steering_quantum_rad = 0.1 * kDegree;

  void describe(FieldList& fields);
};

/// The arc that base_link drives. With the wheels across (delta = +-90 degrees) it turns on the spot.
Arc arc_of(const FrontSteered& vehicle, const FrontSteeredMotion& motion);

/// base_link after the motion, seen from base_link before it. Smooth through delta = 0.
Pose2 drive(const FrontSteered& vehicle, const FrontSteeredMotion& motion);

/// Derivative of that pose (x, y, theta) by (S, delta).
Mat32 drive_jacobian(const FrontSteered& vehicle, const FrontSteeredMotion& motion);

/// That pose with its first-order covariance. No distance reported: no covariance.
UncertainPose2 drive(const FrontSteered& vehicle, const FrontSteeredMotion& motion,
                     const FrontSteeredNoise& noise);

/// The front reference point (origin of the papers' VCS) with the vehicle's heading, in the frame of the
/// vehicle's pose.
Pose2 front_pose(const FrontSteered& vehicle, const Pose2& T_frame_vehicle);

}  // namespace aisle
