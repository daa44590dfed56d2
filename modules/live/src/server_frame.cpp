#include "server_frame.hpp"

#include <bit>
#include <nlohmann/json.hpp>

#include "aisle/formats/sessions/message_schema.hpp"
#include "little_endian.hpp"

namespace aisle {
namespace {

using OrderedJson = nlohmann::ordered_json;

enum ServerOp : char { kMessageData = 1, kTime = 2, kServiceResponse = 3, kPlaybackState = 5 };

OrderedJson time_json(ros::Stamp_ns stamp) {
  constexpr ros::Stamp_ns kSecond_ns = 1'000'000'000;
  return {{"sec", stamp / kSecond_ns}, {"nsec", stamp % kSecond_ns}};
}

/// Statuses quote what clients wrote, so invalid UTF-8 is replaced.
std::string frame_text(const OrderedJson& json) {
  return json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
}

}  // namespace

std::string server_info_frame(const std::string& name, const std::string& version,
                              const std::string& session_id, const Playback* playback) {
  OrderedJson info = {{"op", "serverInfo"},
                      {"name", name},
                      {"capabilities", {"clientPublish", "services", "time"}},
                      {"supportedEncodings", {"json"}},
                      {"metadata", {{"aisle", version}}},
                      {"sessionId", session_id}};
  if (playback != nullptr) {
    info["capabilities"].push_back("playbackControl");
    info["dataStartTime"] = time_json(playback->first);
    info["dataEndTime"] = time_json(playback->last);
  }
  return frame_text(info);
}

std::string advertise_frame(std::span<const LiveChannel> channels) {
  OrderedJson list = OrderedJson::array();
  for (const auto& [id, topic] : channels) {
    list.push_back({{"id", id},
                    {"topic", topic.name},
                    {"encoding", "cdr"},
                    {"schemaName", topic.type},
                    {"schema", message_schema(topic.type)},
                    {"schemaEncoding", "ros2msg"}});
  }
  return frame_text({{"op", "advertise"}, {"channels", std::move(list)}});
}

std::string advertise_services_frame(std::span<const std::string> names) {
  const OrderedJson json = {{"encoding", "json"},
                            {"schemaName", "json"},
                            {"schemaEncoding", "jsonschema"},
                            {"schema", R"({"type":"object"})"}};
  OrderedJson list = OrderedJson::array();
  std::uint32_t id = 0;
  for (const std::string& name : names)
    list.push_back({{"id", ++id}, {"name", name}, {"type", "json"}, {"request", json}, {"response", json}});
  return frame_text({{"op", "advertiseServices"}, {"services", std::move(list)}});
}

std::string status_frame(StatusLevel level, const std::string& message) {
  return frame_text({{"op", "status"}, {"level", static_cast<int>(level)}, {"message", message}});
}

std::string service_failure_frame(std::uint32_t service, std::uint32_t call, const std::string& why) {
  return frame_text(
      {{"op", "serviceCallFailure"}, {"serviceId", service}, {"callId", call}, {"message", why}});
}

std::string message_header(std::uint32_t subscription, ros::Stamp_ns stamp) {
  std::string bytes(1, kMessageData);
  append_little_endian(bytes, subscription);
  append_little_endian(bytes, static_cast<std::uint64_t>(stamp));
  return bytes;
}

std::string time_frame(ros::Stamp_ns stamp) {
  std::string bytes(1, kTime);
  append_little_endian(bytes, static_cast<std::uint64_t>(stamp));
  return bytes;
}

std::string playback_state_frame(const Playback& playback, std::string_view request) {
  std::string bytes(1, kPlaybackState);
  append_little_endian(bytes, static_cast<std::uint8_t>(playback.status));
  append_little_endian(bytes, static_cast<std::uint64_t>(playback.at));
  append_little_endian(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(playback.rate)));
  append_little_endian(bytes, static_cast<std::uint8_t>(playback.did_seek));
  append_little_endian(bytes, static_cast<std::uint32_t>(request.size()));
  bytes += request;
  return bytes;
}

std::string service_response_frame(std::uint32_t service, std::uint32_t call, std::string_view json) {
  constexpr std::string_view kEncoding = "json";
  std::string bytes(1, kServiceResponse);
  append_little_endian(bytes, service);
  append_little_endian(bytes, call);
  append_little_endian(bytes, static_cast<std::uint32_t>(kEncoding.size()));
  bytes += kEncoding;
  bytes += json;
  return bytes;
}

}  // namespace aisle
