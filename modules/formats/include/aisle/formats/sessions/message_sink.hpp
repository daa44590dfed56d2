#pragma once

#include <string_view>

#include "aisle/formats/sessions/session_message.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// Who is shown the messages of a session while they come about.
class MessageSink {
 public:
  virtual ~MessageSink() = default;

  /// @param cdr  valid during the call
  virtual void take(const SessionTopic& topic, ros::Stamp_ns stamp, std::string_view cdr) = 0;

  /// Where the simulator has the vehicle: for setting it down there again, not for showing.
  virtual void take_truth(const Pose2& /*T_map_vehicle*/) {}
};

}  // namespace aisle
