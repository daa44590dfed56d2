#pragma once
/// A vehicle on two wheels with a motor each; base_link is the middle between them. The defaults are the
/// mini-vehicle of L03.

#include "aisle/core/angle.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/geometry/pose2.hpp"
#include "aisle/vehicle/arc.hpp"

namespace aisle {

struct Differential {
  int steps_per_turn = 200;                 ///< motor steps of a full turn of a wheel; > 0
  double wheel_radius_m = 0.043;            ///< > 0
  double wheel_separation_m = 0.186;        ///< between the wheels' contact points; > 0
  double turn_quantum_rad = 2.5 * kDegree;  ///< turns are commanded and recorded in multiples of this

  /// How far a wheel rolls in one step [m]: d = n / 200 * 2 pi r (L03 section 3.1 B).
  double step_length_m() const { return 2 * kPi * wheel_radius_m / steps_per_turn; }

  void describe(FieldList& fields);
};

/// Motor steps since the last report, each wheel at its constant rate; backwards: negative.
struct WheelSteps {
  int left = 0;
  int right = 0;
};

/// How far the wheels' reported motion may be from the real one: standard deviations. Rounding to whole steps
/// is added to them. The scales are the same for every motion of a run: adding up many motions as if they
/// were independent gives too small a covariance.
struct DifferentialNoise {
  double wheel_scale = 0.005;
  double wheel_slip_m_per_sqrt_m = 0.003;
  double separation_scale = 0.01;

  void describe(FieldList& fields);
};

/// The arc that base_link drives.
Arc arc_of(const Differential& vehicle, const WheelSteps& steps);

/// base_link after the steps, seen from base_link before them. Smooth through equal steps.
Pose2 drive(const Differential& vehicle, const WheelSteps& steps);

/// Derivative of that pose (x, y, theta) by the distances of the wheels (left, right) in metres.
Mat32 drive_jacobian(const Differential& vehicle, const WheelSteps& steps);

/// That pose with its first-order covariance. No steps: no covariance.
UncertainPose2 drive(const Differential& vehicle, const WheelSteps& steps, const DifferentialNoise& noise);

/// The steps that turn the vehicle on the spot by `quanta` turn quanta, left positive, to the nearest step.
WheelSteps turn_on_the_spot(const Differential& vehicle, int quanta);

}  // namespace aisle
