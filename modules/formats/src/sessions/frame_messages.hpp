#pragma once
/// Messages for viewers besides the exact readings: frames, dead reckoning, the command as a twist.

#include "aisle/formats/sessions/map_frame.hpp"
#include "aisle/geometry/pose2.hpp"
#include "aisle/vehicle/command.hpp"
#include "aisle/vehicle/observation.hpp"
#include "aisle/vehicle/vehicle_description.hpp"
#include "sessions/session_topics.hpp"

namespace aisle {

/// /odom: the dead-reckoned pose. @param duration_s  of the last motion; 0: unknown
RecordedMessage odometry_message(ros::Stamp_ns stamp, const Pose2& T_odom_vehicle, const Pose2& motion,
                                 double duration_s);

/// /tf: odom -> base_link.
RecordedMessage frames_message(ros::Stamp_ns stamp, const Pose2& T_odom_vehicle);

/// /tf_static: base_link -> every camera and the scanner.
RecordedMessage static_frames_message(ros::Stamp_ns stamp, const VehicleDescription& vehicle);

/// /cmd_vel: the velocity of base_link.
RecordedMessage command_message(const VehicleDescription& vehicle, const Command& command);

/// /truth/pose, in the frame "map".
RecordedMessage true_pose_message(ros::Stamp_ns stamp, const Pose2& T_map_vehicle);

/// The yaw of a rotation about z.
double yaw_of(const ros::Quaternion& rotation);

}  // namespace aisle
