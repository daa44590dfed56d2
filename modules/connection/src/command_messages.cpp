#include "command_messages.hpp"

#include <algorithm>
#include <cmath>

#include "aisle/formats/sessions/cdr.hpp"

namespace aisle {

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

Arc rates_of(const Command& command, const VehicleDescription& vehicle) {
  if (vehicle.is_differential) return {command.speed_mps, command.turn_rate_rad_s};
  return arc_of(vehicle.front_steered, {command.speed_mps, command.steering_rad});
}

std::string command_cdr(const Command& command, CommandKind kind, const VehicleDescription& vehicle,
                        ros::Stamp_ns stamp, const std::string& frame) {
  const ros::Header header{ros::time_of(stamp), frame};
  const Arc rates = rates_of(command, vehicle);
  ros::Twist twist;
  twist.linear.x = rates.length_m;
  twist.angular.z = rates.turn_rad;
  if (kind == CommandKind::kTwist) return cdr_bytes(twist);
  if (kind == CommandKind::kTwistStamped) return cdr_bytes(ros::TwistStamped{header, twist});
  ros::AckermannDriveStamped drive{header, {}};
  drive.drive.speed = static_cast<float>(twist.linear.x);
  drive.drive.steering_angle = static_cast<float>(command.steering_rad);
  return cdr_bytes(drive);
}

}  // namespace aisle
