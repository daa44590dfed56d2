#include "joint_odometry.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {
namespace {

std::optional<double> angle_of(const ros::JointState& message, const std::string& joint) {
  const auto found = std::find(message.name.begin(), message.name.end(), joint);
  const auto index = static_cast<std::size_t>(found - message.name.begin());
  if (found == message.name.end() || index >= message.position.size()) return std::nullopt;
  if (!std::isfinite(message.position[index])) return std::nullopt;
  return message.position[index];
}

}  // namespace

std::optional<Pose2> JointOdometry::take(const ros::JointState& message) {
  const auto left = angle_of(message, left_joint_), right = angle_of(message, right_joint_);
  if (!left || !right) return std::nullopt;
  if (angles_rad_) {
    const double left_m = wheels_.wheel_radius_m * (*left - angles_rad_->first);
    const double right_m = wheels_.wheel_radius_m * (*right - angles_rad_->second);
    T_odom_axle_ =
        T_odom_axle_ * end_pose({(left_m + right_m) / 2, (right_m - left_m) / wheels_.wheel_separation_m});
  }
  angles_rad_ = {*left, *right};
  return T_odom_axle_;
}

}  // namespace aisle
