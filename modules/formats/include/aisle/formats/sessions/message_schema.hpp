#pragma once

#include <string>
#include <string_view>

namespace aisle {

/// The definition of a message of ros_messages.hpp and of all types it contains, in the encoding "ros2msg":
/// enough for a reader that does not know the type.
/// @param type  "sensor_msgs/msg/LaserScan"
/// @throws std::invalid_argument for any other type
std::string message_schema(std::string_view type);

}  // namespace aisle
