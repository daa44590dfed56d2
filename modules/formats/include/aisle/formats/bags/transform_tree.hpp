#pragma once

#include <Eigen/Geometry>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "aisle/formats/sessions/ros_messages.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// A rotation and a translation; nullopt if they are no numbers or the quaternion is zero.
std::optional<Eigen::Isometry3d> isometry(const ros::Vector3& translation, const ros::Quaternion& rotation);

/// The part in the plane: x, y, and where the x axis points.
Pose2 in_the_plane(const Eigen::Isometry3d& T);

/// The transforms of a bag that do not change: those of /tf_static, and of /tf where always the same is sent.
class TransformTree {
 public:
  void add(const std::string& parent, const std::string& child, const Eigen::Isometry3d& T_parent_child);

  bool has_frame(const std::string& frame) const;
  /// The frame with this last part of its name: "base_link" or "robot_1/base_link".
  std::optional<std::string> frame_ending(const std::string& name) const;

  /// T_from_to along constant transforms in either direction; nullopt if none lead there.
  std::optional<Eigen::Isometry3d> find(const std::string& from, const std::string& to) const;

 private:
  struct Edge {
    Eigen::Isometry3d T_parent_child;
    bool is_constant = true;
  };

  std::map<std::pair<std::string, std::string>, Edge> edges_;
};

}  // namespace aisle
