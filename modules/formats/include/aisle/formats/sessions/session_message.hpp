#pragma once

#include <string>
#include <string_view>

#include "aisle/formats/sessions/ros_time.hpp"

namespace aisle {

/// A stream of messages of one type.
struct SessionTopic {
  std::string name;      ///< "/scan"
  std::string type;      ///< "sensor_msgs/msg/LaserScan"
  bool latched = false;  ///< late subscribers still get the last message (transient local)

  friend bool operator==(const SessionTopic&, const SessionTopic&) = default;
};

}  // namespace aisle
