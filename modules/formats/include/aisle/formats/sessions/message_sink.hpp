#pragma once

#include <string_view>

#include "aisle/formats/sessions/session_message.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// Receives the messages of a session while it is recorded.
class MessageSink {
 public:
  virtual ~MessageSink() = default;

  /// @param cdr  valid during the call
  virtual void take(const SessionTopic& topic, ros::Stamp_ns stamp, std::string_view cdr) = 0;

  /// The vehicle's true pose in the simulator: used to put the vehicle back there, never to show it.
  virtual void take_truth(const Pose2& /*T_map_vehicle*/) {}
};

}  // namespace aisle
