#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "aisle/live/client_frame.hpp"
#include "aisle/live/drive_command.hpp"
#include "aisle/live/driver_lease.hpp"
#include "aisle/live/playback.hpp"
#include "aisle/live/service_call.hpp"
#include "send_queue.hpp"
#include "server_frame.hpp"

namespace aisle {

/// The protocol without its sockets: channels, subscriptions, services and the lease. Used by one thread.
class Hub {
 public:
  using Send = std::function<void(OutFrame)>;
  /// Runs something on the hub's thread, from any thread.
  using Post = std::function<void(std::function<void()>)>;

  static constexpr std::size_t kSubscriptionsMax = 1000;
  static constexpr std::size_t kClientChannelsMax = 64;

  /// The services of the lease come first.
  Hub(std::string name, std::string version, std::vector<LiveService> services, const Clock& clock,
      DriveInbox& drive, Post post);

  /// Adds a client and greets it.
  void join(ClientId client, Send send);
  void leave(ClientId client);

  /// @return false if the text is not a message of the protocol
  bool receive_text(ClientId client, std::string_view text);
  bool receive_bytes(ClientId client, std::string_view bytes);

  void publish(const SessionTopic& topic, ros::Stamp_ns stamp, std::shared_ptr<const std::string> cdr);
  void publish_time(ros::Stamp_ns stamp);
  /// A replay has begun, ended (nullopt) or changed how it goes on.
  void show_playback(const std::optional<Playback>& playback);
  /// Nothing is sent after this to the clients that are here.
  void say_goodbye();
  /// Later subscribers get no message from before this call.
  void forget_latched();

  DriverLease& lease() { return lease_; }

 private:
  struct Channel {
    SessionTopic topic;
    ros::Stamp_ns stamp = 0;
    std::shared_ptr<const std::string> latched;  ///< the last message; null: none
  };

  struct Client {
    Send send;
    std::map<std::uint32_t, std::uint32_t> channel_of;       ///< by subscription
    std::map<std::uint32_t, std::uint32_t> subscription_of;  ///< by channel
    std::map<std::uint32_t, ClientChannel> channels;         ///< its own
    bool controls_playback = false;  ///< it knows such messages: older ones take them for an error

    void say(StatusLevel level, const std::string& message) const;
    void send_text(std::string text) const { send({.head = std::move(text), .is_text = true}); }
  };

  struct Reception;

  std::string server_info() const;
  void control_playback(ClientId id, Client& client, const PlaybackRequest& request);
  void answer_playback(ClientId id, const std::string& request, bool is_done, const std::string& text);
  std::uint32_t channel_id(const SessionTopic& topic);
  void subscribe(Client& client, const Subscription& wanted);
  void advertise(Client& client, ClientChannel channel);
  void receive_message(Client& client, const ClientMessage& message);
  void call(ClientId id, Client& client, const ServiceRequest& request);
  void call_mailbox(ClientId id, const ServiceRequest& request, const LiveService& service,
                    nlohmann::json arguments);
  void call_lease(ClientId id, const ServiceRequest& request, const nlohmann::json& arguments);
  void answer(ClientId id, std::uint32_t service, std::uint32_t call, bool is_done, const std::string& text);

  std::string name_, version_;
  std::vector<LiveService> services_;
  DriveInbox& drive_;
  Post post_;
  DriverLease lease_;
  std::optional<Playback> playback_;  ///< of the session that is replayed
  std::string session_;               ///< what clients have received is of this one
  std::uint64_t sessions_ = 0;
  std::vector<Channel> channels_;  ///< ids count from 1
  std::map<std::string, std::uint32_t> ids_;
  std::map<ClientId, Client> clients_;
};

}  // namespace aisle
