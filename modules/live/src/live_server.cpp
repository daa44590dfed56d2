#include "aisle/live/live_server.hpp"

#include <fmt/format.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/address.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <optional>
#include <thread>
#include <utility>

#include "http_connection.hpp"
#include "outbox.hpp"
#include "server_context.hpp"
#include "tls_context.hpp"
#include "tls_handshake.hpp"

namespace aisle {
namespace {

namespace asio = boost::asio;
using Tcp = asio::ip::tcp;

constexpr std::size_t kTokenMin = 16;

using Tls = std::optional<asio::ssl::context>;

Result<asio::ip::address> address_of(const LiveServerOptions& options) {
  boost::system::error_code error;
  const auto address = asio::ip::make_address(options.address, error);
  if (error)
    return Problem{{"--listen"}, fmt::format("'{}' is not an address such as 192.168.1.5", options.address)};
  if (!options.token.empty() && options.token.size() < kTokenMin)
    return Problem{{"--token-file"}, fmt::format("the token must have at least {} characters", kTokenMin)};
  if (!address.is_loopback() && options.token.empty())
    return Problem{{"--listen"}, "an address that others can reach needs --token-file"};
  for (const std::string& origin : options.origins) {
    if (!is_origin(origin))
      return Problem{{"--allow-origin"},
                     fmt::format("'{}' is not an origin such as https://viewer.example", origin)};
  }
  return address;
}

/// An empty result if no encryption is requested.
Result<Tls> tls_of(const LiveServerOptions& options) {
  if (!options.tls.are_given()) return Tls();
  auto context = tls_context(options.tls);
  if (!context) return context.problems();
  return Tls(std::move(*context));
}

}  // namespace

/// The sockets, the thread that serves them, and the messages from the mission's thread.
class LiveServer::Engine {
 public:
  Engine(LiveServerOptions options, const asio::ip::address& address, Tls tls,
         std::vector<LiveService> services)
      : options_(std::move(options)),
        address_(address),
        tls_(std::move(tls)),
        drive_(clock_),
        hub_(options_.name, options_.version, std::move(services), clock_, drive_,
             [this](std::function<void()> work) { asio::post(io_, std::move(work)); }),
        server_context_{
            .hub = hub_,
            .authenticator = Authenticator(address.is_loopback(), options_.token, options_.origins),
            .request_handler = HttpRequestHandler(options_.folders, options_.version)},
        acceptor_(io_) {}

  ~Engine() {
    io_.stop();
    if (thread_.joinable()) thread_.join();
  }
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  Problems start();
  const Tcp::endpoint& endpoint() const { return endpoint_; }
  bool is_encrypted() const { return tls_.has_value(); }

  void take(const SessionTopic& topic, ros::Stamp_ns stamp, std::string_view cdr);
  void take_time(ros::Stamp_ns stamp);
  void forget_latched() {
    asio::post(io_, [this] { hub_.forget_latched(); });
  }
  void show_playback(const std::optional<Playback>& playback) {
    asio::post(io_, [this, playback] {
      drain();
      hub_.show_playback(playback);
    });
  }
  void say_goodbye() {
    asio::post(io_, [this] {
      boost::system::error_code ignored;
      acceptor_.close(ignored);
      drain();
      hub_.say_goodbye();
    });
  }

  DriveInbox& drive() { return drive_; }
  bool lease_is_held() const { return lease_is_held_; }
  std::size_t clients() const { return server_context_.clients; }

 private:
  void accept();
  void admit(Tcp::socket socket);
  void deliver();
  void drain();

  LiveServerOptions options_;
  asio::ip::address address_;
  Tls tls_;
  SteadyClock clock_;
  DriveInbox drive_;
  Hub hub_;
  ServerContext server_context_;
  Outbox outbox_;
  std::atomic<bool> lease_is_held_ = false;
  asio::io_context io_{1};  // owns the connections, which use all members above until their end
  Tcp::acceptor acceptor_;
  Tcp::endpoint endpoint_;
  std::thread thread_;
};

Problems LiveServer::Engine::start() {
  boost::system::error_code error;
  const Tcp::endpoint wanted(address_, options_.port);
  acceptor_.open(wanted.protocol(), error);
  if (!error) acceptor_.set_option(asio::socket_base::reuse_address(true), error);
  if (!error) acceptor_.bind(wanted, error);
  if (!error) acceptor_.listen(asio::socket_base::max_listen_connections, error);
  if (error) {
    return {{{fmt::format("{}:{}", options_.address, options_.port)},
             "cannot be listened on: " + error.message() + "; --port chooses another"}};
  }
  endpoint_ = acceptor_.local_endpoint();
  accept();
  thread_ = std::thread([this] { io_.run(); });
  return {};
}

void LiveServer::Engine::accept() {
  acceptor_.async_accept([this](const boost::system::error_code& error, Tcp::socket socket) {
    if (error == asio::error::operation_aborted) return;
    if (!error) admit(std::move(socket));
    accept();
  });
}

void LiveServer::Engine::admit(Tcp::socket socket) {
  if (server_context_.connections >= kConnectionsMax) return;
  boost::system::error_code ignored;
  socket.set_option(Tcp::no_delay(true), ignored);
  net::PlainStream stream(std::move(socket));
  if (tls_) return std::make_shared<net::TlsHandshake>(std::move(stream), *tls_, server_context_)->start();
  std::make_shared<net::HttpConnection<net::PlainStream>>(std::move(stream), server_context_,
                                                          Counted(server_context_.connections))
      ->read();
}

void LiveServer::Engine::take(const SessionTopic& topic, ros::Stamp_ns stamp, std::string_view cdr) {
  if (outbox_.put(topic, stamp, cdr, server_context_.clients > 0)) deliver();
}

void LiveServer::Engine::take_time(ros::Stamp_ns stamp) {
  if (outbox_.put_time(stamp)) deliver();
}

void LiveServer::Engine::deliver() {
  asio::post(io_, [this] { drain(); });
}

void LiveServer::Engine::drain() {
  for (const Outbox::Item& item : outbox_.take()) {
    if (item.topic.name.empty()) {
      hub_.publish_time(item.stamp);
    } else {
      hub_.publish(item.topic, item.stamp, item.cdr);
    }
  }
  lease_is_held_ = hub_.lease().is_held();
}

Result<std::unique_ptr<LiveServer>> LiveServer::open(LiveServerOptions options,
                                                     std::vector<LiveService> services) {
  const auto address = address_of(options);
  if (!address) return address.problems();
  auto tls = tls_of(options);
  if (!tls) return tls.problems();
  auto engine = std::make_unique<Engine>(std::move(options), *address, std::move(*tls), std::move(services));
  if (Problems problems = engine->start(); !problems.empty()) return problems;
  return std::unique_ptr<LiveServer>(new LiveServer(std::move(engine)));
}

LiveServer::LiveServer(std::unique_ptr<Engine> engine) : engine_(std::move(engine)) {}
LiveServer::~LiveServer() = default;

std::uint16_t LiveServer::port() const {
  return engine_->endpoint().port();
}

std::string LiveServer::url() const {
  const auto endpoint = engine_->endpoint();
  const std::string host = endpoint.address().to_string();
  return fmt::format("{}://{}:{}/", engine_->is_encrypted() ? "https" : "http",
                     endpoint.address().is_v6() ? "[" + host + "]" : host, endpoint.port());
}

bool LiveServer::can_be_overheard() const {
  return !engine_->is_encrypted() && !engine_->endpoint().address().is_loopback();
}

void LiveServer::take(const SessionTopic& topic, ros::Stamp_ns stamp, std::string_view cdr) {
  engine_->take(topic, stamp, cdr);
}
void LiveServer::take_time(ros::Stamp_ns stamp) {
  engine_->take_time(stamp);
}
void LiveServer::forget_latched() {
  engine_->forget_latched();
}
void LiveServer::show_playback(const std::optional<Playback>& playback) {
  engine_->show_playback(playback);
}
void LiveServer::say_goodbye() {
  engine_->say_goodbye();
}
DriveInbox& LiveServer::drive() {
  return engine_->drive();
}
bool LiveServer::lease_is_held() const {
  return engine_->lease_is_held();
}
std::size_t LiveServer::clients() const {
  return engine_->clients();
}

}  // namespace aisle
