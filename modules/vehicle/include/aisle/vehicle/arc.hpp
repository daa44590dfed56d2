#pragma once

#include "aisle/geometry/pose2.hpp"

namespace aisle {

using Mat32 = Eigen::Matrix<double, 3, 2>;

/// Motion of base_link along a circular arc: what a wheeled vehicle does while its controls stay the same. A
/// straight line is the arc that turns by 0, a turn on the spot the arc of length 0.
struct Arc {
  double length_m = 0;  ///< backwards: negative
  double turn_rad = 0;  ///< change of heading, left positive
};

/// base_link at the end of the arc, seen from base_link at its start. Smooth through turn 0.
Pose2 end_pose(const Arc& arc);

/// Derivative of the end pose (x, y, theta) by (length, turn).
Mat32 end_pose_jacobian(const Arc& arc);

}  // namespace aisle
