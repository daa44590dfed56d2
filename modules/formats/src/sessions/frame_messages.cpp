#include "sessions/frame_messages.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <utility>

#include "aisle/vehicle/differential.hpp"
#include "aisle/vehicle/front_steered.hpp"
#include "sessions/image_messages.hpp"

namespace aisle {
namespace {

constexpr const char* kOdometryFrame = "odom";
constexpr const char* kVehicleFrame = "base_link";
constexpr const char* kScannerFrame = "laser";

ros::Quaternion about_z(double angle_rad) {
  return {.z = std::sin(angle_rad / 2), .w = std::cos(angle_rad / 2)};
}

ros::Pose pose(const Pose2& T) {
  return {{.x = T.x, .y = T.y}, about_z(T.theta)};
}

ros::TransformStamped frame(ros::Stamp_ns stamp, const char* parent, std::string child,
                            const ros::Transform& transform) {
  return {{ros::time_of(stamp), parent}, std::move(child), transform};
}

ros::Transform transform(const Pose2& T) {
  return {{.x = T.x, .y = T.y}, about_z(T.theta)};
}

ros::Transform transform(const CameraMount& mount) {
  const Eigen::Quaterniond q(mount.R_vehicle_camera());
  const Vec3& p = mount.p_vehicle_camera;
  return {{p.x(), p.y(), p.z()}, {q.x(), q.y(), q.z(), q.w()}};
}

}  // namespace

RecordedMessage odometry_message(ros::Stamp_ns stamp, const Pose2& T_odom_vehicle, const Pose2& motion,
                                 double duration_s) {
  ros::Odometry message;
  message.header = {ros::time_of(stamp), kOdometryFrame};
  message.child_frame_id = kVehicleFrame;
  message.pose.pose = pose(T_odom_vehicle);
  if (duration_s > 0) {
    message.twist.twist.linear = {.x = motion.x / duration_s, .y = motion.y / duration_s};
    message.twist.twist.angular = {.z = motion.theta / duration_s};
  }
  return recorded(kOdometryTopic, message);
}

RecordedMessage frames_message(ros::Stamp_ns stamp, const Pose2& T_odom_vehicle) {
  return recorded(kFramesTopic,
                  ros::TFMessage{{frame(stamp, kOdometryFrame, kVehicleFrame, transform(T_odom_vehicle))}});
}

RecordedMessage static_frames_message(ros::Stamp_ns stamp, const VehicleDescription& vehicle) {
  ros::TFMessage message;
  for (const CameraDescription& camera : vehicle.cameras) {
    message.transforms.push_back(
        frame(stamp, kVehicleFrame, camera_frame(camera.name), transform(camera.mount)));
  }
  if (vehicle.scanner) {
    message.transforms.push_back(
        frame(stamp, kVehicleFrame, kScannerFrame, transform(vehicle.scanner->T_vehicle_laser)));
  }
  return latched(kStaticFramesTopic, message);
}

RecordedMessage command_message(const VehicleDescription& vehicle, const Command& command) {
  ros::Twist message;
  if (vehicle.is_differential) {
    message.linear.x = command.speed_mps;
    message.angular.z = command.turn_rate_rad_s;
  } else {
    const Arc in_a_second =
        arc_of(vehicle.front_steered, FrontSteeredMotion{command.speed_mps, command.steering_rad});
    message.linear.x = in_a_second.length_m;
    message.angular.z = in_a_second.turn_rad;
  }
  return recorded(kCommandTopic, message);
}

RecordedMessage true_pose_message(ros::Stamp_ns stamp, const Pose2& T_map_vehicle) {
  return recorded(kTruePoseTopic, ros::PoseStamped{{ros::time_of(stamp), kMapFrame}, pose(T_map_vehicle)});
}

double yaw_of(const ros::Quaternion& rotation) {
  const auto& [x, y, z, w] = rotation;
  return std::atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z));
}

}  // namespace aisle
