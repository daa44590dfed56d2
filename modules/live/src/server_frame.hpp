#pragma once
/// Messages from the server in the open Foxglove WebSocket protocol.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "aisle/formats/sessions/session_message.hpp"
#include "aisle/live/playback.hpp"

namespace aisle {

struct LiveChannel {
  std::uint32_t id = 0;
  SessionTopic topic;
};

enum class StatusLevel { kInfo = 0, kWarning = 1, kError = 2 };

/// @param session_id  another one: clients forget what they have received
/// @param playback    null: nothing is being replayed
std::string server_info_frame(const std::string& name, const std::string& version,
                              const std::string& session_id, const Playback* playback);
std::string advertise_frame(std::span<const LiveChannel> channels);
/// Services are numbered from 1 in this order.
std::string advertise_services_frame(std::span<const std::string> names);
std::string status_frame(StatusLevel level, const std::string& message);
std::string service_failure_frame(std::uint32_t service, std::uint32_t call, const std::string& why);

/// The header before the message's own bytes.
std::string message_header(std::uint32_t subscription, ros::Stamp_ns stamp);
std::string time_frame(ros::Stamp_ns stamp);
/// @param request  id of the request that it answers; empty: of none
std::string playback_state_frame(const Playback& playback, std::string_view request);
std::string service_response_frame(std::uint32_t service, std::uint32_t call, std::string_view json);

}  // namespace aisle
