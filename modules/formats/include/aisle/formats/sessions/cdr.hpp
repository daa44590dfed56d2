#pragma once
/// ROS 2 messages as bytes: little-endian CDR after the four-byte encapsulation header.

#include <optional>
#include <string>
#include <string_view>

#include "aisle/formats/sessions/ros_messages.hpp"

namespace aisle {

/// Defined for every message of ros_messages.hpp that has a kType, and for ros::Header.
template <class Message>
std::string cdr_bytes(const Message& message);

/// Reads either byte order; ignores padding after the last field.
/// @return nullopt if the bytes end too early or are not CDR; a length beyond the available bytes is refused
///         before memory is allocated for it
template <class Message>
std::optional<Message> parse_cdr(std::string_view bytes);

}  // namespace aisle
