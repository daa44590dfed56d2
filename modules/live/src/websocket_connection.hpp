#pragma once

#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/field.hpp>
#include <boost/beast/websocket/ssl.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "aisle/core/clock.hpp"
#include "message_rate.hpp"
#include "server_context.hpp"

namespace aisle::net {

namespace beast = boost::beast;
namespace websocket = beast::websocket;

/// A client of the protocol: its messages go to the hub; the hub's messages wait in its queue.
template <class Stream>
class WebSocketConnection : public std::enable_shared_from_this<WebSocketConnection<Stream>> {
 public:
  static constexpr std::size_t kMessageBytesMax = 1 << 20;
  static constexpr double kMessages_per_s = 200;

  WebSocketConnection(Stream stream, ServerContext& server_context, Counted connection)
      : socket_(std::move(stream)), server_context_(server_context), connection_(std::move(connection)) {
    auto timeout = websocket::stream_base::timeout::suggested(beast::role_type::server);
    timeout.idle_timeout = std::chrono::seconds(60);
    timeout.keep_alive_pings = true;
    socket_.set_option(timeout);
    socket_.read_message_max(kMessageBytesMax);
    socket_.auto_fragment(false);
  }

  ~WebSocketConnection() {
    if (id_ != 0) server_context_.hub.leave(id_);
  }

  template <class Request>
  void accept(const Request& request, const std::string& subprotocol) {
    socket_.set_option(websocket::stream_base::decorator([subprotocol](auto& response) {
      response.set(beast::http::field::sec_websocket_protocol, subprotocol);
    }));
    socket_.async_accept(request, [self = this->shared_from_this()](beast::error_code error) {
      if (!error) self->begin();
    });
  }

 private:
  void begin() {
    id_ = ++server_context_.last_client;
    client_.emplace(server_context_.clients);
    server_context_.hub.join(id_, [weak = this->weak_from_this()](OutFrame frame) {
      if (const auto self = weak.lock()) self->send(std::move(frame));
    });
    read();
  }

  void read() {
    socket_.async_read(incoming_, [self = this->shared_from_this()](beast::error_code error, std::size_t) {
      if (!error) self->on_read();
    });
  }

  void on_read() {
    if (!rate_.admit(clock_.now_s()))
      return close({websocket::close_code::policy_error, "too many messages"});
    const auto data = incoming_.cdata();
    const std::string_view message{static_cast<const char*>(data.data()), data.size()};
    const bool makes_sense = socket_.got_text() ? server_context_.hub.receive_text(id_, message)
                                                : server_context_.hub.receive_bytes(id_, message);
    if (!makes_sense) return close({websocket::close_code::unknown_data, "no message of the protocol"});
    incoming_.consume(incoming_.size());
    read();
  }

  void send(OutFrame frame) {
    if (is_closing_) return;
    if (!queue_.push(std::move(frame))) {
      is_closing_ = true;  // it does not read, so a close frame would not reach it
      beast::get_lowest_layer(socket_).close();
      return;
    }
    if (!sent_) write();
  }

  void write() {
    sent_ = queue_.pop();
    if (!sent_) return;
    if (sent_->is_goodbye) return close({websocket::close_code::going_away, "the program ends"});
    socket_.text(sent_->is_text);
    const std::array<boost::asio::const_buffer, 2> buffers{
        boost::asio::buffer(sent_->head),
        sent_->body ? boost::asio::buffer(*sent_->body) : boost::asio::const_buffer()};
    socket_.async_write(buffers, [self = this->shared_from_this()](beast::error_code error, std::size_t) {
      if (!error && !self->is_closing_) self->write();
    });
  }

  void close(const websocket::close_reason& reason) {
    is_closing_ = true;
    socket_.async_close(reason, [self = this->shared_from_this()](beast::error_code) {});
  }

  websocket::stream<Stream> socket_;
  ServerContext& server_context_;
  Counted connection_;
  std::optional<Counted> client_;
  beast::flat_buffer incoming_;
  SteadyClock clock_;
  MessageRate rate_{kMessages_per_s};
  SendQueue queue_;
  std::optional<OutFrame> sent_;  ///< being sent
  ClientId id_ = 0;
  bool is_closing_ = false;
};

}  // namespace aisle::net
