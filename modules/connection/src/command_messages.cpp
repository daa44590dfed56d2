#include "command_messages.hpp"

#include <algorithm>
#include <cmath>

#include "aisle/formats/sessions/cdr.hpp"

namespace aisle {
namespace {

/// Speed and turn rate of base_link.
ros::Twist twist_of(const Command& command, const VehicleDescription& vehicle) {
  ros::Twist twist;
  if (vehicle.is_differential) {
    twist.linear.x = command.speed_mps;
    twist.angular.z = command.turn_rate_rad_s;
  } else {
    twist.linear.x = command.speed_mps * std::cos(command.steering_rad);
    twist.angular.z = command.speed_mps * std::sin(command.steering_rad) / vehicle.front_steered.wheelbase_m;
  }
  return twist;
}

}  // namespace

std::string command_type(CommandKind kind) {
  if (kind == CommandKind::kAckermann) return ros::AckermannDriveStamped::kType;
  return kind == CommandKind::kTwistStamped ? ros::TwistStamped::kType : ros::Twist::kType;
}

std::optional<CommandKind> command_kind(std::string_view type) {
  for (const CommandKind kind : kCommandKinds) {
    if (type == command_type(kind)) return kind;
  }
  return std::nullopt;
}

Command within(const DriveLimits& limits, const Command& command) {
  if (!std::isfinite(command.speed_mps) || !std::isfinite(command.steering_rad) ||
      !std::isfinite(command.turn_rate_rad_s))
    return {};
  return {std::clamp(command.speed_mps, -limits.reverse_speed_max_mps, limits.speed_max_mps),
          std::clamp(command.steering_rad, -limits.steering_max_rad, limits.steering_max_rad),
          std::clamp(command.turn_rate_rad_s, -limits.turn_rate_max_rad_s, limits.turn_rate_max_rad_s)};
}

std::string command_cdr(const Command& command, CommandKind kind, const VehicleDescription& vehicle,
                        ros::Stamp_ns stamp, const std::string& frame) {
  const ros::Header header{ros::time_of(stamp), frame};
  const ros::Twist twist = twist_of(command, vehicle);
  if (kind == CommandKind::kTwist) return cdr_bytes(twist);
  if (kind == CommandKind::kTwistStamped) return cdr_bytes(ros::TwistStamped{header, twist});
  ros::AckermannDriveStamped drive{header, {}};
  drive.drive.speed = static_cast<float>(twist.linear.x);
  drive.drive.steering_angle = static_cast<float>(command.steering_rad);
  return cdr_bytes(drive);
}

}  // namespace aisle
