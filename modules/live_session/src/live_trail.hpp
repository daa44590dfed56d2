#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "aisle/formats/sessions/session_message.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// Where the vehicle has been on the map that is shown, from the messages of a mission: /pose, or /odom where
/// no pose is told.
class LiveTrail {
 public:
  /// A mission begins: another map.
  void begin();
  /// The odometry begins again where the vehicle stands now; the map stays.
  void go_on();

  void take(const SessionTopic& topic, std::string_view cdr);

  /// Where the odometry began on the map that stayed; nullopt: the map is the mission's own.
  const std::optional<Pose2>& T_map_odom() const { return T_map_odom_; }
  /// Where the vehicle is on the map; nullopt: nothing was heard yet.
  std::optional<Vec2> p_map_vehicle() const;
  /// Of all that was driven on this map [m].
  double distance_m() const { return distance_m_; }
  /// {"points": [[x_m, y_m], ...]}: one every 0.1 m, the oldest first.
  nlohmann::ordered_json json() const;

 private:
  void move_to(const Pose2& T_map_vehicle);

  std::optional<Pose2> T_map_odom_;
  std::optional<Pose2> T_map_vehicle_;
  bool has_pose_ = false;
  std::vector<Vec2> p_map_;
  double distance_m_ = 0;
};

/// {"x_m": ..., "y_m": ..., "heading_deg": ...}
nlohmann::ordered_json pose_json(const Pose2& T);

}  // namespace aisle
