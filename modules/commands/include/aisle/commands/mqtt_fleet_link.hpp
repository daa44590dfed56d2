#pragma once

#include <memory>
#include <string>

#include "aisle/fleet/fleet_client.hpp"
#include "aisle/fleet/fleet_link.hpp"
#include "aisle/mqtt/mqtt_client.hpp"

namespace aisle {

/// What time it is: "2026-01-31T12:34:56.789Z".
std::string utc_timestamp();

/// A vehicle's topics at a broker.
class MqttFleetLink final : public FleetLink {
 public:
  /// @param broker  its last will, topics and client are filled in here
  static Result<std::unique_ptr<MqttFleetLink>> connect(MqttSettings broker, const FleetIdentity& identity);

  MqttFleetLink(std::unique_ptr<MqttClient> client, FleetIdentity identity);

  bool is_connected() const override { return client_->is_connected(); }
  std::size_t connections() const override { return client_->connections(); }
  std::vector<FleetMessage> take_received() override;
  void send(const FleetMessage& message, bool is_retained) override;
  void disconnect() { client_->disconnect(); }

 private:
  std::unique_ptr<MqttClient> client_;
  FleetIdentity identity_;
};

}  // namespace aisle
