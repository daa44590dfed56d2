#include "aisle/commands/mqtt_fleet_link.hpp"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <ctime>
#include <utility>

#include "aisle/fleet/fleet_state.hpp"

namespace aisle {

std::string utc_timestamp() {
  const auto now = std::chrono::system_clock::now();
  const auto whole = std::chrono::floor<std::chrono::seconds>(now);
  const std::time_t seconds = std::chrono::system_clock::to_time_t(whole);
  std::tm utc = {};
  gmtime_r(&seconds, &utc);
  std::array<char, 32> text = {};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%S", &utc);
  return fmt::format("{}.{:03}Z", text.data(),
                     std::chrono::duration_cast<std::chrono::milliseconds>(now - whole).count());
}

Result<std::unique_ptr<MqttFleetLink>> MqttFleetLink::connect(MqttSettings broker,
                                                              const FleetIdentity& identity) {
  if (Problems problems = identity.problems(); !problems.empty()) return problems;
  const FleetHeader header{0, utc_timestamp(), identity.manufacturer, identity.serial};
  broker.client_id = "aisle-" + identity.manufacturer + "-" + identity.serial;
  broker.last_will = {identity.topic("connection"), connection_json(header, FleetConnection::kBroken)};
  broker.topics = {identity.topic("order"), identity.topic("instantActions")};
  auto client = MqttClient::connect(broker);
  if (!client) return client.problems();
  return std::make_unique<MqttFleetLink>(std::move(*client), identity);
}

MqttFleetLink::MqttFleetLink(std::unique_ptr<MqttClient> client, FleetIdentity identity)
    : client_(std::move(client)), identity_(std::move(identity)) {}

std::vector<FleetMessage> MqttFleetLink::take_received() {
  std::vector<FleetMessage> messages;
  for (MqttMessage& message : client_->take_received())
    messages.push_back({message.topic.substr(message.topic.rfind('/') + 1), std::move(message.payload)});
  return messages;
}

/// VDA 5050 asks for quality 1 where a client's connection is said, and 0 for the rest.
void MqttFleetLink::send(const FleetMessage& message, bool is_retained) {
  client_->publish({identity_.topic(message.topic), message.json}, message.topic == "connection" ? 1 : 0,
                   is_retained);
}

}  // namespace aisle
