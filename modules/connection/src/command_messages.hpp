#pragma once
/// What a robot is told: aisle's commands in its own terms.

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "aisle/formats/connections/connection_file.hpp"
#include "aisle/formats/sessions/ros_time.hpp"
#include "aisle/vehicle/arc.hpp"
#include "aisle/vehicle/command.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

using CommandKind = ConnectedCommands::Kind;

/// The kinds of messages that robots read, best first.
inline constexpr std::array<CommandKind, 3> kCommandKinds = {CommandKind::kAckermann,
                                                             CommandKind::kTwistStamped, CommandKind::kTwist};

/// "geometry_msgs/msg/Twist"
std::string command_type(CommandKind kind);
std::optional<CommandKind> command_kind(std::string_view type);

/// The command within the vehicle's limits; a value that is not finite means: stop.
Command within(const DriveLimits& limits, const Command& command);

/// What base_link does in a second under a command.
Arc rates_of(const Command& command, const VehicleDescription& vehicle);

/// @param kind   not kAuto
/// @param stamp  for the kinds that have one
/// @param frame  of base_link, for the kinds that have one
std::string command_cdr(const Command& command, CommandKind kind, const VehicleDescription& vehicle,
                        ros::Stamp_ns stamp, const std::string& frame);

}  // namespace aisle
