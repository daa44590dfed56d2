#pragma once
/// ROS 2 messages as bytes: CDR, little endian, after its four bytes of encapsulation.

#include <optional>
#include <string>
#include <string_view>

#include "aisle/formats/sessions/ros_messages.hpp"

namespace aisle {

/// Defined for every message of ros_messages.hpp that has a kType.
template <class Message>
std::string cdr_bytes(const Message& message);

/// Either byte order is read; padding after the last field is not looked at.
/// @return nullopt if the bytes end too early or are no CDR; lengths are never believed beyond the bytes
///         that are there
template <class Message>
std::optional<Message> parse_cdr(std::string_view bytes);

}  // namespace aisle
