#pragma once

#include <optional>
#include <string_view>

#include "aisle/formats/sessions/ros_messages.hpp"

namespace aisle {

/// How the messages of a topic are written as bytes.
enum class BagEncoding {
  kCdr,   ///< ROS 2: see cdr.hpp
  kRos1,  ///< ROS 1: little-endian, nothing aligned; headers begin with a sequence number
};

/// Reads a message of ros_messages.hpp that has a kType.
/// @return nullopt if the bytes end too early or are not in this encoding
template <class Message>
std::optional<Message> parse_message(std::string_view bytes, BagEncoding encoding);

/// The header of any message that begins with one.
std::optional<ros::Header> parse_header(std::string_view bytes, BagEncoding encoding);

}  // namespace aisle
