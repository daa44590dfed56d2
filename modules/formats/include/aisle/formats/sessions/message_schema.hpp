#pragma once

#include <string>
#include <string_view>

namespace aisle {

/// The definition of a message of ros_messages.hpp and of all that it is made of, in the encoding "ros2msg":
/// what a reader needs who has never heard of the type.
/// @param type  "sensor_msgs/msg/LaserScan"
/// @throws std::invalid_argument if it is none of those
std::string message_schema(std::string_view type);

}  // namespace aisle
