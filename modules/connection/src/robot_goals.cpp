#include "aisle/connection/robot_goals.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "aisle/formats/bags/bag_scan.hpp"
#include "aisle/formats/bags/transform_tree.hpp"
#include "aisle/formats/sessions/cdr.hpp"
#include "map_frame.hpp"

namespace aisle {
namespace {

const ros::Pose& pose_in(const ros::PoseStamped& message) {
  return message.pose;
}
const ros::Pose& pose_in(const ros::PoseWithCovarianceStamped& message) {
  return message.pose.pose;
}

}  // namespace

Result<std::unique_ptr<RobotGoals>> RobotGoals::open(Wire& wire, const Connection& connection, Note note) {
  auto goals = std::make_unique<RobotGoals>(std::move(note));
  goals->goal_.topic = connection.topic("goal_pose");
  goals->initial_.topic = connection.topic("initialpose");
  Problems problems = goals->subscribe<ros::PoseStamped>(wire, goals->goal_);
  for (Problem& problem : goals->subscribe<ros::PoseWithCovarianceStamped>(wire, goals->initial_))
    problems.push_back(std::move(problem));
  if (!problems.empty()) return problems;
  return goals;
}

template <class Message>
Problems RobotGoals::subscribe(Wire& wire, Inbox& inbox) {
  auto subscription = wire.subscribe(
      inbox.topic, Message::kType, WireQuality::kSensor, [this, &inbox](std::string_view bytes) {
        const auto message = parse_cdr<Message>(bytes);
        const auto T_map =
            message ? isometry(pose_in(*message).position, pose_in(*message).orientation) : std::nullopt;
        const std::lock_guard lock(mutex_);
        inbox.T_map.reset();
        if (!T_map) {
          inbox.refused = "is no pose";
        } else if (frame_name(message->header.frame_id) != kMapFrameId) {
          inbox.refused =
              fmt::format("is in the frame '{}', not in '{}'", message->header.frame_id, kMapFrameId);
        } else {
          inbox.T_map = in_the_plane(*T_map);
        }
      });
  if (!subscription) return subscription.problems();
  subscriptions_.push_back(std::move(*subscription));
  return {};
}

std::optional<Pose2> RobotGoals::take(Inbox& inbox) {
  std::string refused;
  std::optional<Pose2> T_map;
  {
    const std::lock_guard lock(mutex_);
    refused = std::exchange(inbox.refused, {});
    T_map = std::exchange(inbox.T_map, std::nullopt);
  }
  if (!refused.empty()) note_(fmt::format("{} {}", inbox.topic, refused));
  return T_map;
}

}  // namespace aisle
