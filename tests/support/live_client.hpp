#pragma once
/// A small client of the live server, written from the protocol's specification alone.

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace aisle {

struct LiveHttpReply {
  unsigned status = 0;
  std::string body;
};

/// One request on its own connection.
inline LiveHttpReply live_http(std::uint16_t port, const std::string& method, const std::string& target,
                               const std::map<std::string, std::string>& headers = {},
                               const std::string& body = {}) {
  namespace http = boost::beast::http;
  boost::asio::io_context io;
  boost::beast::tcp_stream stream(io);
  stream.connect({boost::asio::ip::make_address("127.0.0.1"), port});
  http::request<http::string_body> request{http::string_to_verb(method), target, 11};
  request.set(http::field::host, "127.0.0.1:" + std::to_string(port));
  for (const auto& [name, value] : headers) request.set(name, value);
  request.body() = body;
  request.prepare_payload();
  boost::beast::error_code error;
  http::write(stream, request, error);
  boost::beast::flat_buffer buffer;
  http::response_parser<http::string_body> parser;
  parser.body_limit(std::uint64_t{1} << 30);
  http::read(stream, buffer, parser, error);
  if (error && error != http::error::end_of_stream) throw std::runtime_error(error.message());
  return {parser.get().result_int(), parser.get().body()};
}

class LiveClient {
 public:
  struct Message {
    std::string topic;
    std::uint64_t stamp = 0;
    std::string cdr;
  };
  struct PlaybackState {
    int status = 0;
    std::uint64_t stamp = 0;
    bool did_seek = false;
    std::string request;
  };

  explicit LiveClient(std::uint16_t port, const std::map<std::string, std::string>& headers = {},
                      const std::string& target = "/",
                      const std::string& subprotocol = "foxglove.websocket.v1") {
    namespace beast = boost::beast;
    beast::get_lowest_layer(socket_).connect({boost::asio::ip::make_address("127.0.0.1"), port});
    socket_.read_message_max(std::size_t{64} << 20);
    socket_.set_option(beast::websocket::stream_base::decorator([=](beast::websocket::request_type& request) {
      if (!subprotocol.empty()) request.set(beast::http::field::sec_websocket_protocol, subprotocol);
      for (const auto& [name, value] : headers) request.set(name, value);
    }));
    socket_.handshake("127.0.0.1:" + std::to_string(port), target);
  }

  /// Takes all messages until `done`; throws after the time-out, or when the connection is closed.
  void read_until(const std::function<bool()>& done,
                  std::chrono::seconds longest = std::chrono::seconds(30)) {
    const auto end = std::chrono::steady_clock::now() + longest;
    while (!done()) {
      if (std::chrono::steady_clock::now() > end) throw std::runtime_error("it did not come");
      read();
    }
  }

  /// Takes one message of the server.
  void read() {
    buffer_.clear();
    boost::beast::get_lowest_layer(socket_).expires_after(std::chrono::seconds(30));
    socket_.read(buffer_);
    const auto data = buffer_.cdata();
    const std::string_view frame{static_cast<const char*>(data.data()), data.size()};
    socket_.got_text() ? take_text(nlohmann::json::parse(frame)) : take_bytes(frame);
  }

  void send_text(const std::string& text) {
    socket_.text(true);
    socket_.write(boost::asio::buffer(text));
  }
  void send_bytes(const std::string& bytes) {
    socket_.text(false);
    socket_.write(boost::asio::buffer(bytes));
  }

  /// Subscribes to every channel, also to those that are advertised later.
  void subscribe_to_all() {
    wants_all_ = true;
    for (const auto& [id, topic] : topics) subscribe(id);
  }

  /// The answer; throws with the reason if the call is refused.
  nlohmann::json call(const std::string& service,
                      const nlohmann::json& arguments = nlohmann::json::object()) {
    read_until([&] { return services.contains(service); });
    const std::uint32_t call = ++last_call_;
    send_bytes("\x02" + uint32(services.at(service)) + uint32(call) + uint32(4) + "json" + arguments.dump());
    read_until([&] { return answers_.contains(call); });
    const auto [is_done, text] = answers_.at(call);
    if (!is_done) throw std::runtime_error(text);
    return nlohmann::json::parse(text);
  }

  void advertise_drive() {
    send_text(
        R"({"op":"advertise","channels":[{"id":1,"topic":"/drive","encoding":"json","schemaName":"drive"}]})");
  }
  void drive(const nlohmann::json& command) { send_bytes("\x01" + uint32(1) + command.dump()); }

  /// Pauses a replay at a time.
  void pause_at(std::uint64_t stamp, const std::string& request) {
    const std::string once = uint32(0x3f800000);  // as fast as it happened
    send_bytes("\x03\x01" + once + "\x01" + uint32(static_cast<std::uint32_t>(stamp)) +
               uint32(static_cast<std::uint32_t>(stamp >> 32)) +
               uint32(static_cast<std::uint32_t>(request.size())) + request);
  }

  void close() { socket_.close(boost::beast::websocket::close_code::normal); }

  std::map<std::uint32_t, std::string> topics;  ///< by channel
  std::map<std::uint32_t, nlohmann::json> channels;
  std::map<std::string, std::uint32_t> services;
  std::vector<Message> messages;
  std::vector<PlaybackState> playback;
  std::vector<std::string> statuses;
  nlohmann::json server_info;
  std::uint64_t time_ns = 0;

 private:
  static std::string uint32(std::uint32_t number) {
    std::string bytes;
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(number >> 8 * i & 0xff);
    return bytes;
  }
  static std::uint64_t number_in(std::string_view bytes, std::size_t at, std::size_t count) {
    std::uint64_t number = 0;
    for (std::size_t i = count; i-- > 0;) number = number << 8 | static_cast<unsigned char>(bytes.at(at + i));
    return number;
  }

  void subscribe(std::uint32_t channel) {
    send_text(nlohmann::json({{"op", "subscribe"},
                              {"subscriptions", {{{"id", channel + 1000}, {"channelId", channel}}}}})
                  .dump());
  }

  void take_text(const nlohmann::json& json) {
    const std::string op = json["op"];
    if (op == "serverInfo") server_info = json;
    if (op == "status") statuses.push_back(json["message"]);
    if (op == "serviceCallFailure") answers_[json["callId"]] = {false, json["message"].get<std::string>()};
    if (op == "advertiseServices") {
      for (const auto& service : json["services"]) services[service["name"]] = service["id"];
    }
    if (op != "advertise") return;
    for (const auto& channel : json["channels"]) {
      const std::uint32_t id = channel["id"];
      topics[id] = channel["topic"];
      channels[id] = channel;
      if (wants_all_) subscribe(id);
    }
  }

  void take_bytes(std::string_view frame) {
    const char op = frame.at(0);
    if (op == 1) {
      const auto channel = static_cast<std::uint32_t>(number_in(frame, 1, 4)) - 1000;
      messages.push_back({topics.at(channel), number_in(frame, 5, 8), std::string(frame.substr(13))});
    } else if (op == 2) {
      time_ns = number_in(frame, 1, 8);
    } else if (op == 3) {
      const std::size_t length = number_in(frame, 9, 4);
      answers_[static_cast<std::uint32_t>(number_in(frame, 5, 4))] = {true,
                                                                      std::string(frame.substr(13 + length))};
    } else if (op == 5) {
      playback.push_back({.status = frame.at(1),
                          .stamp = number_in(frame, 2, 8),
                          .did_seek = frame.at(14) != 0,
                          .request = std::string(frame.substr(19, number_in(frame, 15, 4)))});
    } else {
      throw std::runtime_error("no message of the protocol");
    }
  }

  boost::asio::io_context io_;
  boost::beast::websocket::stream<boost::beast::tcp_stream> socket_{io_};
  boost::beast::flat_buffer buffer_;
  bool wants_all_ = false;
  std::uint32_t last_call_ = 0;
  std::map<std::uint32_t, std::pair<bool, std::string>> answers_;
};

}  // namespace aisle
