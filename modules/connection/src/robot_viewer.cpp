#include "aisle/connection/robot_viewer.hpp"

#include <cmath>
#include <utility>

#include "aisle/formats/sessions/cdr.hpp"
#include "aisle/formats/sessions/map_messages.hpp"

namespace aisle {
namespace {

constexpr const char* kMapFrame = "map";

Pose2 pose_of(const ros::Pose& pose) {
  return {pose.position.x, pose.position.y, 2 * std::atan2(pose.orientation.z, pose.orientation.w)};
}

ros::TransformStamped transform(ros::Stamp_ns stamp, const std::string& child, const Pose2& T_map_child) {
  ros::TransformStamped message;
  message.header = {ros::time_of(stamp), kMapFrame};
  message.child_frame_id = child;
  message.transform.translation = {T_map_child.x, T_map_child.y, 0};
  message.transform.rotation = {0, 0, std::sin(T_map_child.theta / 2), std::cos(T_map_child.theta / 2)};
  return message;
}

/// The message with the robot's stamp in the place of the mission's.
template <class Message>
std::string restamped(std::string_view cdr, ros::Stamp_ns stamp) {
  auto message = parse_cdr<Message>(cdr);
  if (!message) return std::string(cdr);
  message->header.stamp = ros::time_of(stamp);
  return cdr_bytes(*message);
}

}  // namespace

RobotViewer::RobotViewer(Wire& wire, const Connection& connection, const ConnectedVehicle& vehicle,
                         MessageSink* next)
    : wire_(wire), connection_(connection), vehicle_(vehicle), next_(next) {}

void RobotViewer::take(const SessionTopic& topic, ros::Stamp_ns stamp, std::string_view cdr) {
  if (next_ != nullptr) next_->take(topic, stamp, cdr);
  const ros::Stamp_ns now = vehicle_.odometry().stamp;
  if (topic == grid_topic()) {
    publish(topic, connection_.topic("map"), restamped<ros::OccupancyGrid>(cdr, now));
  } else if (topic == plan_topic()) {
    publish(topic, connection_.topic("plan"), restamped<ros::Path>(cdr, now));
  } else if (topic == pose_topic()) {
    publish_pose(cdr);
  }
}

void RobotViewer::publish(const SessionTopic& topic, const std::string& name, std::string_view cdr) {
  auto& publisher = publishers_[name];
  if (!publisher) {
    auto advertised =
        wire_.advertise(name, topic.type, topic.latched ? WireQuality::kLatched : WireQuality::kDefault);
    if (!advertised) return;  // nothing that is driven depends on it
    publisher = std::move(*advertised);
  }
  publisher->publish(cdr);
}

void RobotViewer::publish_pose(std::string_view cdr) {
  const auto message = parse_cdr<ros::PoseWithCovarianceStamped>(cdr);
  if (!message) return;
  const ConnectedVehicle::Odometry& odometry = vehicle_.odometry();
  const Pose2 T_map_odom = pose_of(message->pose.pose) * odometry.T_odom_vehicle.inverse();
  static const SessionTopic transforms{"/tf", ros::TFMessage::kType};
  publish(transforms, "/tf",
          cdr_bytes(ros::TFMessage{{transform(odometry.stamp, connection_.frames.odom, T_map_odom)}}));
}

}  // namespace aisle
