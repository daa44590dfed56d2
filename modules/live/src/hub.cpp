#include "hub.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "aisle/formats/json_document.hpp"

namespace aisle {
namespace {

constexpr const char* kDriveTopic = "/drive";
constexpr const char* kTakeLease = "lease/take";
constexpr const char* kRenewLease = "lease/renew";
constexpr const char* kReleaseLease = "lease/release";
constexpr const char* kPlayReplay = "replay/play";
constexpr const char* kControlReplay = "replay/control";  // by the protocol's own message alone

std::string lease_in(const nlohmann::json& arguments) {
  const auto found = arguments.find("lease");
  return found != arguments.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::vector<LiveService> with_lease_services(std::vector<LiveService> services) {
  services.insert(services.begin(), {{.name = kTakeLease},
                                     {.name = kRenewLease, .needs_lease = true},
                                     {.name = kReleaseLease, .needs_lease = true}});
  return services;
}

}  // namespace

Hub::Hub(std::string name, std::string version, std::vector<LiveService> services, const Clock& clock,
         DriveInbox& drive, Post post)
    : name_(std::move(name)),
      version_(std::move(version)),
      services_(with_lease_services(std::move(services))),
      drive_(drive),
      post_(std::move(post)),
      lease_(clock, chance_token),
      session_(chance_token()) {}

std::string Hub::server_info() const {
  return server_info_frame(name_, version_, fmt::format("{}-{}", session_, sessions_),
                           playback_ ? &*playback_ : nullptr);
}

void Hub::join(ClientId id, Send send) {
  const Client& client =
      clients_[id] = {.send = std::move(send), .channel_of = {}, .subscription_of = {}, .channels = {}};
  client.send_text(server_info());
  std::vector<LiveChannel> channels;
  channels.reserve(channels_.size());
  for (const Channel& channel : channels_)
    channels.push_back({static_cast<std::uint32_t>(channels.size() + 1), channel.topic});
  if (!channels.empty()) client.send_text(advertise_frame(channels));
  std::vector<std::string> names;
  names.reserve(services_.size());
  for (const LiveService& service : services_) names.push_back(service.name);
  client.send_text(advertise_services_frame(names));
}

void Hub::leave(ClientId client) {
  clients_.erase(client);
  lease_.gone(client);
}

void Hub::Client::say(StatusLevel level, const std::string& message) const {
  send_text(status_frame(level, message));
}

/// Handles a client's messages by type.
struct Hub::Reception {
  Hub& hub;
  ClientId id;
  Client& client;

  void operator()(const SubscribeRequest& request) const {
    for (const Subscription& wanted : request.subscriptions) hub.subscribe(client, wanted);
  }
  void operator()(const UnsubscribeRequest& request) const {
    for (const std::uint32_t subscription : request.subscriptions) {
      const auto found = client.channel_of.find(subscription);
      if (found == client.channel_of.end()) {
        client.say(StatusLevel::kWarning, fmt::format("there is no subscription {}", subscription));
        continue;
      }
      client.subscription_of.erase(found->second);
      client.channel_of.erase(found);
    }
  }
  void operator()(AdvertiseRequest& request) const {
    for (ClientChannel& channel : request.channels) hub.advertise(client, std::move(channel));
  }
  void operator()(const UnadvertiseRequest& request) const {
    for (const std::uint32_t channel : request.channels) client.channels.erase(channel);
  }
  void operator()(const UnofferedRequest& request) const {
    client.say(StatusLevel::kWarning, fmt::format("'{}' is not offered", request.op.substr(0, 64)));
  }
  void operator()(const ClientMessage& message) const { hub.receive_message(client, message); }
  void operator()(const ServiceRequest& request) const { hub.call(id, client, request); }
  void operator()(const PlaybackRequest& request) const { hub.control_playback(id, client, request); }
};

bool Hub::receive_text(ClientId client, std::string_view text) {
  auto frame = parse_client_text(text);
  if (!frame) return false;
  std::visit(Reception{*this, client, clients_.at(client)}, *frame);
  return true;
}

bool Hub::receive_bytes(ClientId client, std::string_view bytes) {
  auto frame = parse_client_bytes(bytes);
  if (!frame) return false;
  std::visit(Reception{*this, client, clients_.at(client)}, *frame);
  return true;
}

std::uint32_t Hub::channel_id(const SessionTopic& topic) {
  const auto [found, is_new] = ids_.try_emplace(topic.name, static_cast<std::uint32_t>(channels_.size() + 1));
  if (is_new) {
    channels_.push_back({.topic = topic, .latched = {}});
    const LiveChannel channel[] = {{found->second, topic}};
    for (const auto& [id, client] : clients_) client.send_text(advertise_frame(channel));
  }
  return found->second;
}

void Hub::publish(const SessionTopic& topic, ros::Stamp_ns stamp, std::shared_ptr<const std::string> cdr) {
  const std::uint32_t id = channel_id(topic);
  for (const auto& [client_id, client] : clients_) {
    const auto subscription = client.subscription_of.find(id);
    if (subscription == client.subscription_of.end()) continue;
    client.send(
        {.head = message_header(subscription->second, stamp), .body = cdr, .may_be_lost = !topic.latched});
  }
  if (!topic.latched) return;
  channels_[id - 1].stamp = stamp;
  channels_[id - 1].latched = std::move(cdr);
}

void Hub::show_playback(const std::optional<Playback>& playback) {
  const bool begins_or_ends = playback.has_value() != playback_.has_value();
  playback_ = playback;
  if (begins_or_ends) ++sessions_;
  for (const auto& [id, client] : clients_) {
    if (begins_or_ends) client.send_text(server_info());
    if (playback_ && client.controls_playback)
      client.send({.head = playback_state_frame(*playback_, ""), .body = {}});
  }
}

/// Nothing moves by it, so no lease is needed; but who holds one is not disturbed.
void Hub::control_playback(ClientId id, Client& client, const PlaybackRequest& request) {
  client.controls_playback = true;
  const std::string request_id(request.id);
  const auto replay = std::find_if(services_.begin(), services_.end(),
                                   [](const LiveService& service) { return service.name == kPlayReplay; });
  if (!playback_ || replay == services_.end())
    return answer_playback(id, request_id, false, "nothing is being replayed");
  if (lease_.is_held_by_another(id))
    return answer_playback(id, request_id, false, "another client has the controls");
  nlohmann::json arguments = {{"plays", request.plays}, {"rate", request.rate}};
  if (request.seek_to_ns) arguments["seek_to_ns"] = *request.seek_to_ns;
  const auto reply = [this, id, request_id](bool is_done, std::string text) {
    post_([this, id, request_id, is_done, said = std::move(text)] {
      answer_playback(id, request_id, is_done, said);
    });
  };
  if (!replay->mailbox->put({kControlReplay, std::move(arguments), reply}))
    answer_playback(id, request_id, false, "too many requests at once");
}

/// What was refused is answered, too: the viewer's controls show what is.
void Hub::answer_playback(ClientId id, const std::string& request, bool is_done, const std::string& text) {
  const auto client = clients_.find(id);
  if (client == clients_.end()) return;
  if (!is_done) client->second.say(StatusLevel::kWarning, text);
  if (playback_) client->second.send({.head = playback_state_frame(*playback_, request), .body = {}});
}

void Hub::publish_time(ros::Stamp_ns stamp) {
  if (playback_) playback_->at = stamp;
  for (const auto& [id, client] : clients_)
    client.send({.head = time_frame(stamp), .body = {}, .may_be_lost = true});
}

void Hub::say_goodbye() {
  for (const auto& [id, client] : clients_) client.send({.head = {}, .body = {}, .is_goodbye = true});
}

void Hub::forget_latched() {
  for (Channel& channel : channels_) channel.latched.reset();
}

void Hub::subscribe(Client& client, const Subscription& wanted) {
  if (client.channel_of.size() >= kSubscriptionsMax) {
    client.say(StatusLevel::kError, fmt::format("more than {} subscriptions", kSubscriptionsMax));
  } else if (wanted.channel == 0 || wanted.channel > channels_.size()) {
    client.say(StatusLevel::kWarning, fmt::format("there is no channel {}", wanted.channel));
  } else if (client.channel_of.contains(wanted.id)) {
    client.say(StatusLevel::kError, fmt::format("there is a subscription {} already", wanted.id));
  } else if (client.subscription_of.contains(wanted.channel)) {
    client.say(StatusLevel::kWarning, fmt::format("channel {} is subscribed to already", wanted.channel));
  } else {
    client.channel_of[wanted.id] = wanted.channel;
    client.subscription_of[wanted.channel] = wanted.id;
    const Channel& channel = channels_[wanted.channel - 1];
    if (channel.latched)
      client.send({.head = message_header(wanted.id, channel.stamp), .body = channel.latched});
  }
}

void Hub::advertise(Client& client, ClientChannel channel) {
  if (channel.topic != kDriveTopic || channel.encoding != "json") {
    client.say(StatusLevel::kWarning,
               fmt::format("only the topic {} is accepted, with the encoding json", kDriveTopic));
  } else if (client.channels.size() >= kClientChannelsMax) {
    client.say(StatusLevel::kError, fmt::format("more than {} channels", kClientChannelsMax));
  } else {
    client.channels[channel.id] = std::move(channel);
  }
}

void Hub::receive_message(Client& client, const ClientMessage& message) {
  if (!client.channels.contains(message.channel)) {
    client.say(StatusLevel::kError, fmt::format("there is no channel {} of yours", message.channel));
    return;
  }
  const auto command = parse_drive_command(message.data);
  if (!command) {
    client.say(StatusLevel::kError, "a drive command needs lease, sequence and finite numbers");
  } else if (!lease_.renew(command->lease)) {
    client.say(StatusLevel::kWarning, "the lease is not valid: the command is ignored");
  } else if (!drive_.put(*command)) {
    client.say(StatusLevel::kWarning,
               fmt::format("sequence {} is not larger than the last one: the command is ignored",
                           command->sequence));
  }
}

void Hub::call(ClientId id, Client& client, const ServiceRequest& request) {
  const auto fail = [&](const std::string& why) {
    client.send_text(service_failure_frame(request.service, request.call, why));
  };
  if (request.service == 0 || request.service > services_.size()) return fail("there is no such service");
  if (request.encoding != "json") return fail("the encoding must be json");
  auto document = parse_json(request.data.empty() ? "{}" : request.data, "");
  if (!document || !document->is_object()) return fail("the arguments must be a JSON object");
  nlohmann::json& arguments = *document;
  const LiveService& service = services_[request.service - 1];
  if (service.needs_lease && !lease_.renew(lease_in(arguments)))
    return fail("needs the driver's lease, which is missing or no longer valid");
  if (service.mailbox == nullptr) return call_lease(id, request, arguments);
  call_mailbox(id, request, service, std::move(arguments));
}

void Hub::call_mailbox(ClientId id, const ServiceRequest& request, const LiveService& service,
                       nlohmann::json arguments) {
  const auto reply = [this, id, service_id = request.service, call = request.call](bool is_done,
                                                                                   std::string text) {
    post_([this, id, service_id, call, is_done, said = std::move(text)] {
      answer(id, service_id, call, is_done, said);
    });
  };
  if (!service.mailbox->put({service.name, std::move(arguments), reply}))
    answer(id, request.service, request.call, false, "too many requests at once");
}

void Hub::call_lease(ClientId id, const ServiceRequest& request, const nlohmann::json& arguments) {
  const std::string& name = services_[request.service - 1].name;
  const auto done = [&](const nlohmann::ordered_json& json) {
    answer(id, request.service, request.call, true, json.dump());
  };
  if (name == kTakeLease) {
    const auto token = lease_.take(id);
    if (!token) return answer(id, request.service, request.call, false, "another client is driving");
    drive_.begin_lease();
    return done({{"lease", *token}, {"valid_s", DriverLease::kValid_s}});
  }
  if (name == kRenewLease) return done({{"valid_s", DriverLease::kValid_s}});
  lease_.release(lease_in(arguments));
  done(nlohmann::ordered_json::object());
}

void Hub::answer(ClientId id, std::uint32_t service, std::uint32_t call, bool is_done,
                 const std::string& text) {
  const auto client = clients_.find(id);
  if (client == clients_.end()) return;
  if (is_done) {
    client->second.send({.head = service_response_frame(service, call, text), .body = {}});
  } else {
    client->second.send_text(service_failure_frame(service, call, text));
  }
}

}  // namespace aisle
