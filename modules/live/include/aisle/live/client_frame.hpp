#pragma once
/// Messages from clients of the open Foxglove WebSocket protocol.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace aisle {

struct Subscription {
  std::uint32_t id = 0;  ///< chosen by the client
  std::uint32_t channel = 0;
};

struct SubscribeRequest {
  std::vector<Subscription> subscriptions;
};

struct UnsubscribeRequest {
  std::vector<std::uint32_t> subscriptions;
};

/// A channel on which a client wants to publish.
struct ClientChannel {
  std::uint32_t id = 0;  ///< chosen by the client
  std::string topic;
  std::string encoding;
};

struct AdvertiseRequest {
  std::vector<ClientChannel> channels;
};

struct UnadvertiseRequest {
  std::vector<std::uint32_t> channels;
};

/// A well-formed request for a capability that this server does not offer.
struct UnofferedRequest {
  std::string op;
};

struct ClientMessage {
  std::uint32_t channel = 0;
  std::string_view data;  ///< points into the frame
};

struct ServiceRequest {
  std::uint32_t service = 0;
  std::uint32_t call = 0;
  std::string_view encoding;  ///< points into the frame, as `data` does
  std::string_view data;
};

/// How a viewer wants the replayed session to go on.
struct PlaybackRequest {
  bool plays = false;
  float rate = 1;                                ///< finite
  std::optional<std::uint64_t> seek_to_ns = {};  ///< stamp in the session
  std::string_view id;                           ///< points into the frame; repeated in the answer
};

using ClientFrame = std::variant<SubscribeRequest, UnsubscribeRequest, AdvertiseRequest, UnadvertiseRequest,
                                 UnofferedRequest, ClientMessage, ServiceRequest, PlaybackRequest>;

/// @return nullopt if the text is not such a message
std::optional<ClientFrame> parse_client_text(std::string_view text);

/// Views in the result point into `bytes`.
/// @return nullopt if the bytes are not such a message
std::optional<ClientFrame> parse_client_bytes(std::string_view bytes);

}  // namespace aisle
