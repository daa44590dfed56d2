#include "live_trail.hpp"

#include <cmath>

#include "aisle/core/rounded.hpp"
#include "aisle/formats/sessions/cdr.hpp"

namespace aisle {
namespace {

constexpr double kTrailEvery_m = 0.1;

Pose2 planar(const ros::Pose& pose) {
  const ros::Quaternion& q = pose.orientation;
  return {pose.position.x, pose.position.y,
          std::atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z))};
}

}  // namespace

nlohmann::ordered_json pose_json(const Pose2& T) {
  return {
      {"x_m", rounded(T.x, 3)}, {"y_m", rounded(T.y, 3)}, {"heading_deg", rounded(to_degrees(T.theta), 2)}};
}

void LiveTrail::begin() {
  *this = {};
}

void LiveTrail::go_on() {
  T_map_odom_ = T_map_vehicle_;
  has_pose_ = false;
}

void LiveTrail::take(const SessionTopic& topic, std::string_view cdr) {
  if (topic.name == "/pose") {
    const auto message = parse_cdr<ros::PoseWithCovarianceStamped>(cdr);
    if (!message) return;
    if (!has_pose_) p_map_.clear();
    has_pose_ = true;
    move_to(planar(message->pose.pose));
  } else if (topic.name == "/odom" && !has_pose_) {
    const auto message = parse_cdr<ros::Odometry>(cdr);
    if (message) move_to(T_map_odom_.value_or(Pose2{}) * planar(message->pose.pose));
  }
}

void LiveTrail::move_to(const Pose2& T_map_vehicle) {
  if (!T_map_vehicle.is_finite()) return;
  T_map_vehicle_ = T_map_vehicle;
  const Vec2 p_map = T_map_vehicle.position();
  const double step_m = p_map_.empty() ? 0 : (p_map - p_map_.back()).norm();
  if (!p_map_.empty() && step_m < kTrailEvery_m) return;
  p_map_.push_back(p_map);
  distance_m_ += step_m;
}

std::optional<Vec2> LiveTrail::p_map_vehicle() const {
  return T_map_vehicle_ ? std::optional(T_map_vehicle_->position()) : std::nullopt;
}

nlohmann::ordered_json LiveTrail::json() const {
  auto points = nlohmann::ordered_json::array();
  for (const Vec2& p_map : p_map_) points.push_back({rounded(p_map.x(), 2), rounded(p_map.y(), 2)});
  return {{"points", std::move(points)}};
}

}  // namespace aisle
