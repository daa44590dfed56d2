#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>

#include "aisle/connection/connected_vehicle.hpp"
#include "aisle/formats/connections/connection_file.hpp"
#include "aisle/formats/sessions/message_sink.hpp"
#include "aisle/wire/wire.hpp"

namespace aisle {

/// Publishes what a mission knows where the robot's own viewers look for it (RViz, Foxglove, Nav2): the floor
/// as /map, the planned path as /plan, the pose as the transform from "map" to the odometry's frame. The
/// stamps are the robot's. What the robot says of its battery goes the other way. Where another program
/// publishes the same, it does not, and says so once.
class RobotViewer final : public MessageSink {
 public:
  /// All must outlive the viewer.
  /// @param next  receives everything, too; may be null
  /// @param note  of what is left to another program; never empty
  RobotViewer(Wire& wire, const Connection& connection, const ConnectedVehicle& vehicle, MessageSink* next,
              std::function<void(const std::string&)> note);

  void take(const SessionTopic& topic, ros::Stamp_ns stamp, std::string_view cdr) override;

 private:
  void pass_battery_on(ros::Stamp_ns stamp);
  void publish(const SessionTopic& topic, const std::string& name, std::string_view cdr);
  void publish_pose(std::string_view cdr);
  bool is_of_another(const std::string& name);
  void leave(const std::string& what);
  void hear_transforms(std::string_view cdr);

  Wire& wire_;
  const Connection& connection_;
  const ConnectedVehicle& vehicle_;
  MessageSink* next_;
  std::function<void(const std::string&)> note_;
  std::set<std::string> left_;  ///< to other programs
  std::optional<ros::Stamp_ns> battery_passed_;
  std::mutex mutex_;
  std::deque<std::string> own_transforms_;  ///< the latest
  bool others_place_odom_ = false;          ///< another program publishes the same transform
  std::map<std::string, std::unique_ptr<WirePublisher>> publishers_;  ///< by topic
  std::unique_ptr<WireSubscription> transforms_;                      ///< last: it ends before what it fills
};

}  // namespace aisle
