#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "aisle/core/result.hpp"

namespace aisle {

struct MqttMessage {
  std::string topic;
  std::string payload;
};

struct MqttSettings {
  std::string url = {};  ///< mqtt://HOST[:1883], or mqtts://HOST[:8883] by TLS
  std::string client_id = {};
  std::string user = {}, password = {};  ///< empty: no login
  std::string ca_file = {};    ///< PEM of who vouches for the broker; empty: those that the machine trusts
  MqttMessage last_will = {};  ///< said for this client, retained, when its connection breaks
  std::vector<std::string> topics = {};  ///< subscribed to on every connection
  double connect_s = 5;                  ///< how long the first connection may take
  double keep_alive_s = 5;               ///< so soon the broker notices that this client is gone
};

/// A client of an MQTT 3.1.1 broker, by Eclipse Paho. Its threads collect what comes in a queue; whoever owns
/// it polls that. A broken connection is made again by itself, within a few seconds of the broker's return.
class MqttClient {
 public:
  /// Problems: a bad URL, a broker that cannot be reached or refuses the login, a certificate that nobody
  /// vouches for.
  static Result<std::unique_ptr<MqttClient>> connect(const MqttSettings& settings);

  virtual ~MqttClient() = default;

  virtual bool is_connected() const = 0;
  /// Connections made since the start, each with its subscriptions.
  virtual std::size_t connections() const = 0;
  /// What has come since the last call, oldest first. The oldest are dropped if nobody polls.
  virtual std::vector<MqttMessage> take_received() = 0;
  virtual std::size_t dropped() const = 0;
  /// @param quality  of service: 0 (at most once) or 1 (at least once)
  /// @return false if there is no connection: the message is lost, and never sent later
  virtual bool publish(const MqttMessage& message, int quality, bool is_retained) = 0;
  /// Sends what is under way and ends the connection, so that the last will is not said.
  virtual void disconnect() = 0;
};

}  // namespace aisle
