#include "aisle/formats/bags/transform_tree.hpp"

#include <cmath>

namespace aisle {
namespace {

constexpr double kStill_m = 1e-3;
constexpr double kStill_rad = 1e-3;

bool is_same(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  const Eigen::Isometry3d between = a.inverse() * b;
  return between.translation().norm() < kStill_m &&
         std::abs(Eigen::AngleAxisd(between.linear()).angle()) < kStill_rad;
}

}  // namespace

std::optional<Eigen::Isometry3d> isometry(const ros::Vector3& translation, const ros::Quaternion& rotation) {
  const Eigen::Vector3d t(translation.x, translation.y, translation.z);
  const Eigen::Quaterniond q(rotation.w, rotation.x, rotation.y, rotation.z);
  if (!t.allFinite() || !q.coeffs().allFinite() || q.norm() < 1e-6) return std::nullopt;
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = q.normalized().toRotationMatrix();
  T.translation() = t;
  return T;
}

Pose2 in_the_plane(const Eigen::Isometry3d& T) {
  return {T.translation().x(), T.translation().y(), std::atan2(T.linear()(1, 0), T.linear()(0, 0))};
}

void TransformTree::add(const std::string& parent, const std::string& child,
                        const Eigen::Isometry3d& T_parent_child) {
  const auto [edge, is_new] = edges_.try_emplace({parent, child}, Edge{T_parent_child});
  if (!is_new && edge->second.is_constant)
    edge->second.is_constant = is_same(edge->second.T_parent_child, T_parent_child);
}

bool TransformTree::has_frame(const std::string& frame) const {
  for (const auto& [frames, edge] : edges_) {
    if (frames.first == frame || frames.second == frame) return true;
  }
  return false;
}

std::optional<std::string> TransformTree::frame_ending(const std::string& name) const {
  const auto ends = [&](const std::string& frame) { return frame == name || frame.ends_with("/" + name); };
  for (const auto& [frames, edge] : edges_) {
    if (ends(frames.first)) return frames.first;
    if (ends(frames.second)) return frames.second;
  }
  return std::nullopt;
}

std::optional<Eigen::Isometry3d> TransformTree::find(const std::string& from, const std::string& to) const {
  std::map<std::string, Eigen::Isometry3d> T_from{{from, Eigen::Isometry3d::Identity()}};
  std::vector<std::string> open{from};
  while (!open.empty()) {
    const std::string frame = open.back();
    open.pop_back();
    if (frame == to) return T_from.at(to);
    const Eigen::Isometry3d T_from_frame = T_from.at(frame);
    for (const auto& [frames, edge] : edges_) {
      const auto& [parent, child] = frames;
      if (!edge.is_constant || (parent != frame && child != frame)) continue;
      const std::string& next = parent == frame ? child : parent;
      const Eigen::Isometry3d T_frame_next =
          parent == frame ? edge.T_parent_child : edge.T_parent_child.inverse();
      if (T_from.try_emplace(next, T_from_frame * T_frame_next).second) open.push_back(next);
    }
  }
  return std::nullopt;
}

}  // namespace aisle
