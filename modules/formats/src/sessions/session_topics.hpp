#pragma once
/// The topics of a session; docs/formats/session.md says what they mean and which of them are exact.

#include <optional>
#include <string>
#include <string_view>

#include "aisle/core/result.hpp"
#include "aisle/formats/sessions/cdr.hpp"
#include "aisle/formats/sessions/session_message.hpp"

namespace aisle {

inline constexpr const char* kVehicleTopic = "/vehicle_description";
inline constexpr const char* kOriginTopic = "/session";
inline constexpr const char* kStaticFramesTopic = "/tf_static";
inline constexpr const char* kWheelsTopic = "/wheels";
inline constexpr const char* kOdometryTopic = "/odom";
inline constexpr const char* kFramesTopic = "/tf";
inline constexpr const char* kScanTopic = "/scan";
inline constexpr const char* kBumperTopic = "/bumper";
inline constexpr const char* kOperatorTopic = "/operator";
inline constexpr const char* kDecisionTopic = "/decision";
inline constexpr const char* kGoalsTopic = "/goals";
inline constexpr const char* kCommandTopic = "/cmd_vel";
inline constexpr const char* kControlsTopic = "/controls";
inline constexpr const char* kTruePoseTopic = "/truth/pose";

/// A message as stored in a session.
struct RecordedMessage {
  SessionTopic topic;
  std::string cdr;
};

template <class Message>
RecordedMessage recorded(std::string topic, const Message& message) {
  return {{std::move(topic), Message::kType}, cdr_bytes(message)};
}

template <class Message>
RecordedMessage latched(std::string topic, const Message& message) {
  return {{std::move(topic), Message::kType, true}, cdr_bytes(message)};
}

/// The decoded message, or a problem that names topic and type.
template <class Message>
Result<Message> decoded(const RecordedMessage& message, const std::string& file) {
  if (message.topic.type != Message::kType) {
    return Problem{{file, 0, message.topic.name},
                   "has messages of type " + message.topic.type + " instead of " + Message::kType};
  }
  std::optional<Message> value = parse_cdr<Message>(message.cdr);
  if (!value)
    return Problem{{file, 0, message.topic.name}, std::string("contains no CDR of ") + Message::kType};
  return *std::move(value);
}

}  // namespace aisle
