#include "aisle/connection/robot_viewer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "aisle/formats/bags/bag_scan.hpp"
#include "aisle/formats/bags/transform_tree.hpp"
#include "aisle/formats/sessions/cdr.hpp"
#include "aisle/formats/sessions/map_frame.hpp"
#include "aisle/formats/sessions/map_messages.hpp"

namespace aisle {
namespace {

constexpr const char* kTransforms = "/tf";
constexpr ros::Stamp_ns kBatteryEvery_ns = 2'000'000'000;
constexpr double kBatteryNews_s = 60;  // some robots speak of it seldom
constexpr std::size_t kOwnKept = 50;   // of transforms, which come back over the network

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
                         MessageSink* next, std::function<void(const std::string&)> note)
    : wire_(wire), connection_(connection), vehicle_(vehicle), next_(next), note_(std::move(note)) {
  auto transforms = wire.subscribe(kTransforms, ros::TFMessage::kType, WireQuality::kSensor,
                                   [this](std::string_view cdr) { hear_transforms(cdr); });
  if (transforms) transforms_ = std::move(*transforms);
}

void RobotViewer::take(const SessionTopic& topic, ros::Stamp_ns stamp, std::string_view cdr) {
  if (next_ != nullptr) {
    pass_battery_on(stamp);
    next_->take(topic, stamp, cdr);
  }
  const ros::Stamp_ns now = vehicle_.odometry().stamp;
  if (topic == grid_topic()) {
    publish(topic, connection_.topic("map"), restamped<ros::OccupancyGrid>(cdr, now));
  } else if (topic == plan_topic()) {
    publish(topic, connection_.topic("plan"), restamped<ros::Path>(cdr, now));
  } else if (topic == pose_topic()) {
    publish_pose(cdr);
  }
}

/// Again and again while it is news, for who joins late; what is old is passed on no more.
void RobotViewer::pass_battery_on(ros::Stamp_ns stamp) {
  if (battery_passed_ && stamp >= *battery_passed_ && stamp < *battery_passed_ + kBatteryEvery_ns) return;
  const auto battery = vehicle_.battery();
  if (!battery || battery->age_s > kBatteryNews_s) return;
  battery_passed_ = stamp;
  static const SessionTopic topic{"/battery", ros::String::kType};
  next_->take(topic, stamp, cdr_bytes(ros::String{fmt::format(R"({{"charge":{:.3f}}})", battery->charge)}));
}

/// A robot has many publishers of transforms; which of them says where the map is, only the messages tell.
bool RobotViewer::is_of_another(const std::string& name) {
  if (left_.count(name) > 0) return true;
  const auto others = wire_.endpoints();
  const bool is_there =
      name != kTransforms && std::any_of(others.begin(), others.end(), [&](const WireEndpoint& endpoint) {
        return endpoint.kind == WireEndpoint::Kind::kPublisher && endpoint.topic == name;
      });
  if (is_there) leave(name);
  return is_there;
}

void RobotViewer::leave(const std::string& what) {
  if (left_.insert(what).second)
    note_(fmt::format("{} is published by another program: this one leaves it to that", what));
}

void RobotViewer::hear_transforms(std::string_view cdr) {
  const auto message = parse_cdr<ros::TFMessage>(cdr);
  if (!message) return;
  const std::lock_guard lock(mutex_);
  // The network fills messages up to a multiple of four bytes.
  const auto is_own = [&](const std::string& own) { return cdr.starts_with(own); };
  if (std::any_of(own_transforms_.begin(), own_transforms_.end(), is_own)) return;
  for (const ros::TransformStamped& transform : message->transforms)
    others_place_odom_ |= frame_name(transform.header.frame_id) == kMapFrame &&
                          frame_name(transform.child_frame_id) == connection_.frames.odom;
}

void RobotViewer::publish(const SessionTopic& topic, const std::string& name, std::string_view cdr) {
  if (is_of_another(name)) return;
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
  const std::string own =
      cdr_bytes(ros::TFMessage{{transform(odometry.stamp, connection_.frames.odom, T_map_odom)}});
  bool is_left = false;
  {
    const std::lock_guard lock(mutex_);
    own_transforms_.push_back(own);
    if (own_transforms_.size() > kOwnKept) own_transforms_.pop_front();
    is_left = others_place_odom_;
  }
  if (is_left) return leave(fmt::format("the transform from {} to {}", kMapFrame, connection_.frames.odom));
  static const SessionTopic transforms{kTransforms, ros::TFMessage::kType};
  publish(transforms, kTransforms, own);
}

}  // namespace aisle
