#include "aisle/live/client_frame.hpp"

#include <bit>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "aisle/formats/json_document.hpp"
#include "little_endian.hpp"

namespace aisle {
namespace {

using Json = nlohmann::json;

constexpr char kClientMessageOp = 1;
constexpr char kServiceRequestOp = 2;
constexpr char kPlaybackRequestOp = 3;
constexpr char kPauseCommand = 1;  // 0: play

std::optional<std::uint32_t> id_in(const Json& value) {
  if (!value.is_number_unsigned()) return std::nullopt;
  const auto id = value.get<std::uint64_t>();
  if (id > std::numeric_limits<std::uint32_t>::max()) return std::nullopt;
  return static_cast<std::uint32_t>(id);
}

std::optional<std::uint32_t> id_at(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found == object.end() ? std::nullopt : id_in(*found);
}

std::optional<std::string> text_at(const Json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_string()) return std::nullopt;
  return found->get<std::string>();
}

std::optional<Subscription> subscription_in(const Json& value) {
  if (!value.is_object()) return std::nullopt;
  const auto id = id_at(value, "id"), channel = id_at(value, "channelId");
  if (!id || !channel) return std::nullopt;
  return Subscription{*id, *channel};
}

std::optional<ClientChannel> channel_in(const Json& value) {
  if (!value.is_object()) return std::nullopt;
  const auto id = id_at(value, "id");
  auto topic = text_at(value, "topic"), encoding = text_at(value, "encoding");
  if (!id || !topic || !encoding) return std::nullopt;
  return ClientChannel{*id, std::move(*topic), std::move(*encoding)};
}

/// The elements of the list at `key`; nullopt if any is malformed.
template <class Element>
std::optional<std::vector<Element>> list_at(const Json& object, const char* key,
                                            std::optional<Element> (*read)(const Json&)) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_array()) return std::nullopt;
  std::vector<Element> list;
  list.reserve(found->size());
  for (const Json& value : *found) {
    auto element = read(value);
    if (!element) return std::nullopt;
    list.push_back(std::move(*element));
  }
  return list;
}

template <class Request, class Element>
std::optional<ClientFrame> request_of(std::optional<std::vector<Element>> list) {
  if (!list) return std::nullopt;
  return Request{std::move(*list)};
}

std::optional<ClientFrame> playback_request_in(LittleEndianReader& reader) {
  const auto command = reader.byte();
  const auto rate_bits = reader.uint32();
  const auto seeks = reader.byte();
  const auto seek_to_ns = reader.uint64();  // there in any case
  const auto length = reader.uint32();
  if (!command || !rate_bits || !seeks || !seek_to_ns || !length) return std::nullopt;
  const auto id = reader.bytes(*length);
  const auto rate = std::bit_cast<float>(*rate_bits);
  if (!id || static_cast<unsigned char>(*command) > kPauseCommand || !std::isfinite(rate))
    return std::nullopt;
  PlaybackRequest request{.plays = *command != kPauseCommand, .rate = rate, .id = *id};
  if (*seeks != 0) request.seek_to_ns = *seek_to_ns;
  return request;
}

}  // namespace

std::optional<ClientFrame> parse_client_text(std::string_view text) {
  const auto document = parse_json(text, "");
  if (!document || !document->is_object()) return std::nullopt;
  const Json& message = *document;
  auto op = text_at(message, "op");
  if (!op) return std::nullopt;
  if (*op == "subscribe")
    return request_of<SubscribeRequest>(list_at(message, "subscriptions", subscription_in));
  if (*op == "unsubscribe") return request_of<UnsubscribeRequest>(list_at(message, "subscriptionIds", id_in));
  if (*op == "advertise") return request_of<AdvertiseRequest>(list_at(message, "channels", channel_in));
  if (*op == "unadvertise") return request_of<UnadvertiseRequest>(list_at(message, "channelIds", id_in));
  return UnofferedRequest{std::move(*op)};
}

std::optional<ClientFrame> parse_client_bytes(std::string_view bytes) {
  LittleEndianReader reader(bytes);
  const auto op = reader.byte();
  if (op == kClientMessageOp) {
    const auto channel = reader.uint32();
    if (!channel) return std::nullopt;
    return ClientMessage{*channel, reader.rest()};
  }
  if (op == kPlaybackRequestOp) return playback_request_in(reader);
  if (op != kServiceRequestOp) return std::nullopt;
  const auto service = reader.uint32(), call = reader.uint32(), length = reader.uint32();
  if (!service || !call || !length) return std::nullopt;
  const auto encoding = reader.bytes(*length);
  if (!encoding) return std::nullopt;
  return ServiceRequest{*service, *call, *encoding, reader.rest()};
}

}  // namespace aisle
