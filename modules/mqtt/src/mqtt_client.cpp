#include "aisle/mqtt/mqtt_client.hpp"

#include <MQTTAsync.h>
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <string_view>
#include <utility>

namespace aisle {
namespace {

constexpr std::size_t kQueueMax = 1000;
constexpr std::size_t kPayloadMax_bytes = std::size_t{1} << 20;
constexpr int kRetryLeast_s = 1, kRetryMost_s = 4;
constexpr int kFlush_ms = 1000;

/// The URL as Paho wants it; nullopt: neither mqtt:// nor mqtts://.
std::optional<std::string> paho_url(const std::string& url) {
  const auto with_port = [](std::string_view host, const char* scheme,
                            int port) -> std::optional<std::string> {
    while (host.ends_with('/')) host.remove_suffix(1);
    if (host.empty() || host.find('/') != std::string_view::npos) return std::nullopt;
    const std::size_t bracket = host.rfind(']');  // of an IPv6 address
    const std::size_t colon = host.rfind(':');
    const bool has_port =
        colon != std::string_view::npos && (bracket == std::string_view::npos || colon > bracket);
    return has_port ? fmt::format("{}://{}", scheme, host) : fmt::format("{}://{}:{}", scheme, host, port);
  };
  constexpr std::string_view kPlain = "mqtt://", kByTls = "mqtts://";
  if (url.starts_with(kPlain)) return with_port(std::string_view(url).substr(kPlain.size()), "tcp", 1883);
  if (url.starts_with(kByTls)) return with_port(std::string_view(url).substr(kByTls.size()), "ssl", 8883);
  return std::nullopt;
}

std::string why_failed(const MQTTAsync_failureData* failure) {
  if (failure == nullptr) return "no answer";
  // What a broker answers by MQTT 3.1.1 when it refuses.
  switch (failure->code) {
    case 4:
      return "the broker refuses the user or the password";
    case 5:
      return "the broker does not allow this client";
    default:
      break;
  }
  const char* const known = MQTTAsync_strerror(failure->code);
  return fmt::format("{}{}", known != nullptr ? known : "error",
                     failure->message != nullptr ? fmt::format(" ({})", failure->message) : "");
}

class PahoClient final : public MqttClient {
 public:
  explicit PahoClient(MqttSettings settings) : settings_(std::move(settings)) {}
  PahoClient(const PahoClient&) = delete;
  PahoClient& operator=(const PahoClient&) = delete;

  ~PahoClient() override {
    disconnect();
    if (handle_ != nullptr) MQTTAsync_destroy(&handle_);
  }

  Problems open(const std::string& url) {
    MQTTAsync_createOptions create = MQTTAsync_createOptions_initializer;
    create.sendWhileDisconnected = 0;
    if (MQTTAsync_createWithOptions(&handle_, url.c_str(), settings_.client_id.c_str(),
                                    MQTTCLIENT_PERSISTENCE_NONE, nullptr, &create) != MQTTASYNC_SUCCESS)
      return {{{settings_.url}, "is no broker's URL"}};
    MQTTAsync_setCallbacks(handle_, this, on_lost, on_message, nullptr);
    MQTTAsync_setConnected(handle_, this, on_connected);
    return begin_connecting();
  }

  bool is_connected() const override { return is_ready_ && MQTTAsync_isConnected(handle_) != 0; }
  std::size_t connections() const override { return connections_; }
  std::size_t dropped() const override { return dropped_; }

  std::vector<MqttMessage> take_received() override {
    const std::lock_guard lock(mutex_);
    std::vector<MqttMessage> messages(std::make_move_iterator(received_.begin()),
                                      std::make_move_iterator(received_.end()));
    received_.clear();
    return messages;
  }

  bool publish(const MqttMessage& message, int quality, bool is_retained) override {
    if (!is_connected()) return false;
    return MQTTAsync_send(handle_, message.topic.c_str(), static_cast<int>(message.payload.size()),
                          message.payload.data(), quality, is_retained ? 1 : 0, nullptr) == MQTTASYNC_SUCCESS;
  }

  void disconnect() override {
    if (handle_ == nullptr || std::exchange(has_left_, true)) return;
    is_ready_ = false;
    MQTTAsync_disconnectOptions options = MQTTAsync_disconnectOptions_initializer;
    options.timeout = kFlush_ms;
    options.context = this;
    options.onSuccess = [](void* self, MQTTAsync_successData*) { as_client(self).say(kLeft, {}); };
    options.onFailure = [](void* self, MQTTAsync_failureData*) { as_client(self).say(kLeft, {}); };
    if (MQTTAsync_disconnect(handle_, &options) != MQTTASYNC_SUCCESS) return;
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, std::chrono::milliseconds(2 * kFlush_ms), [this] { return phase_ == kLeft; });
  }

 private:
  enum Phase { kConnecting, kConnected, kRefused, kLeft };

  static PahoClient& as_client(void* self) { return *static_cast<PahoClient*>(self); }

  Problems begin_connecting() {
    MQTTAsync_connectOptions options = MQTTAsync_connectOptions_initializer;
    MQTTAsync_willOptions will = MQTTAsync_willOptions_initializer;
    MQTTAsync_SSLOptions tls = MQTTAsync_SSLOptions_initializer;
    will.topicName = settings_.last_will.topic.c_str();
    will.message = settings_.last_will.payload.c_str();
    will.retained = 1;
    will.qos = 1;
    tls.verify = 1;
    tls.enableServerCertAuth = 1;
    tls.trustStore = settings_.ca_file.empty() ? nullptr : settings_.ca_file.c_str();
    // Paho trusts nobody by itself unless it is told a directory.
    if (settings_.ca_file.empty()) tls.CApath = "/etc/ssl/certs";
    if (!settings_.last_will.topic.empty()) options.will = &will;
    if (settings_.url.starts_with("mqtts://")) options.ssl = &tls;
    if (!settings_.user.empty()) options.username = settings_.user.c_str();
    if (!settings_.password.empty()) options.password = settings_.password.c_str();
    options.keepAliveInterval = static_cast<int>(settings_.keep_alive_s);
    options.connectTimeout = static_cast<int>(settings_.connect_s);
    options.cleansession = 1;
    options.MQTTVersion = MQTTVERSION_3_1_1;
    options.automaticReconnect = 1;
    options.minRetryInterval = kRetryLeast_s;
    options.maxRetryInterval = kRetryMost_s;
    options.context = this;
    options.onFailure = [](void* self, MQTTAsync_failureData* failure) {
      as_client(self).say(kRefused, why_failed(failure));
    };
    if (const int code = MQTTAsync_connect(handle_, &options); code != MQTTASYNC_SUCCESS)
      return {{{settings_.url}, fmt::format("cannot be connected to ({})", code)}};
    std::unique_lock lock(mutex_);
    const auto longest = std::chrono::duration<double>(settings_.connect_s + 1);
    changed_.wait_for(lock, longest, [this] { return phase_ != kConnecting; });
    if (phase_ == kConnected) return {};
    return {{{settings_.url}, fmt::format("cannot be connected to: {}", why_.empty() ? "no answer" : why_)}};
  }

  void say(Phase phase, const std::string& why) {
    const std::lock_guard lock(mutex_);
    phase_ = phase;
    why_ = why;
    changed_.notify_all();
  }

  /// On Paho's thread, after each connection: what was subscribed to is forgotten by the broker.
  static void on_connected(void* self, char*) {
    PahoClient& client = as_client(self);
    if (client.settings_.topics.empty()) return client.begin();
    std::vector<char*> topics;
    for (std::string& topic : client.settings_.topics) topics.push_back(topic.data());
    const std::vector<int> qualities(topics.size(), 1);
    MQTTAsync_responseOptions response = MQTTAsync_responseOptions_initializer;
    response.context = self;
    response.onSuccess = [](void* of, MQTTAsync_successData*) { as_client(of).begin(); };
    response.onFailure = [](void* of, MQTTAsync_failureData* failure) {
      as_client(of).say(kRefused, "the broker refuses the subscription: " + why_failed(failure));
    };
    MQTTAsync_subscribeMany(client.handle_, static_cast<int>(topics.size()), topics.data(), qualities.data(),
                            &response);
  }

  /// Only who can be told something may be said to be there.
  void begin() {
    ++connections_;
    is_ready_ = true;
    say(kConnected, {});
  }

  static void on_lost(void* self, char*) { as_client(self).is_ready_ = false; }

  /// On Paho's thread. @return 1: the message was taken
  static int on_message(void* self, char* topic, int topic_length, MQTTAsync_message* message) {
    as_client(self).keep(
        topic_length > 0 ? std::string(topic, static_cast<std::size_t>(topic_length)) : topic, *message);
    MQTTAsync_freeMessage(&message);
    MQTTAsync_free(topic);
    return 1;
  }

  void keep(std::string topic, const MQTTAsync_message& message) {
    const auto size = static_cast<std::size_t>(std::max(0, message.payloadlen));
    const std::lock_guard lock(mutex_);
    if (size > kPayloadMax_bytes) {
      ++dropped_;
      return;
    }
    received_.push_back({std::move(topic), std::string(static_cast<const char*>(message.payload), size)});
    if (received_.size() <= kQueueMax) return;
    received_.pop_front();
    ++dropped_;
  }

  MqttSettings settings_;
  MQTTAsync handle_ = nullptr;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  Phase phase_ = kConnecting;         // by mutex_
  std::string why_;                   // by mutex_
  std::deque<MqttMessage> received_;  // by mutex_
  std::atomic<std::size_t> connections_ = 0, dropped_ = 0;
  std::atomic<bool> is_ready_ = false;
  bool has_left_ = false;
};

}  // namespace

Result<std::unique_ptr<MqttClient>> MqttClient::connect(const MqttSettings& settings) {
  const auto url = paho_url(settings.url);
  if (!url) return Problem{{settings.url}, "is neither mqtt://HOST[:PORT] nor mqtts://HOST[:PORT]"};
  auto client = std::make_unique<PahoClient>(settings);
  if (Problems problems = client->open(*url); !problems.empty()) return problems;
  return std::unique_ptr<MqttClient>(std::move(client));
}

}  // namespace aisle
