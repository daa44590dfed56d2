#pragma once

#include <optional>
#include <utility>

#include "aisle/formats/connections/connection_file.hpp"
#include "aisle/formats/sessions/ros_messages.hpp"
#include "aisle/vehicle/differential.hpp"

namespace aisle {

/// Sums up the angles of two driven wheels.
class JointOdometry {
 public:
  JointOdometry(const ConnectedOdometry& odometry, const Differential& wheels)
      : left_joint_(odometry.left_joint), right_joint_(odometry.right_joint), wheels_(wheels) {}

  /// @return the middle of the axle, seen from where it was at the first message; nullopt: the message is of
  ///         other joints
  std::optional<Pose2> take(const ros::JointState& message);

 private:
  std::string left_joint_, right_joint_;
  Differential wheels_;
  std::optional<std::pair<double, double>> angles_rad_;  ///< of the last message, left and right
  Pose2 T_odom_axle_;
};

}  // namespace aisle
