#pragma once

#include <map>
#include <memory>
#include <string>

#include "aisle/connection/connected_vehicle.hpp"
#include "aisle/formats/connections/connection_file.hpp"
#include "aisle/formats/sessions/message_sink.hpp"
#include "aisle/wire/wire.hpp"

namespace aisle {

/// Publishes what a mission knows where the robot's own viewers look for it (RViz, Foxglove, Nav2): the floor
/// as /map, the planned path as /plan, the pose as the transform from "map" to the odometry's frame. The
/// stamps are the robot's.
class RobotViewer final : public MessageSink {
 public:
  /// All must outlive the viewer.
  /// @param next  receives everything, too; may be null
  RobotViewer(Wire& wire, const Connection& connection, const ConnectedVehicle& vehicle, MessageSink* next);

  void take(const SessionTopic& topic, ros::Stamp_ns stamp, std::string_view cdr) override;

 private:
  void publish(const SessionTopic& topic, const std::string& name, std::string_view cdr);
  void publish_pose(std::string_view cdr);

  Wire& wire_;
  const Connection& connection_;
  const ConnectedVehicle& vehicle_;
  MessageSink* next_;
  std::map<std::string, std::unique_ptr<WirePublisher>> publishers_;  ///< by topic
};

}  // namespace aisle
