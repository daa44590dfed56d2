#pragma once

#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "streams.hpp"
#include "websocket_connection.hpp"

namespace aisle::net {

namespace http = beast::http;

/// Handles the requests of one connection until it ends or becomes a WebSocket.
template <class Stream>
class HttpConnection : public std::enable_shared_from_this<HttpConnection<Stream>> {
 public:
  static constexpr std::uint32_t kHeaderBytesMax = 16 << 10;
  static constexpr std::chrono::seconds kTimeout{30};

  HttpConnection(Stream stream, ServerContext& server_context, Counted connection)
      : stream_(std::move(stream)), server_context_(server_context), connection_(std::move(connection)) {}

  void read() {
    parser_.emplace();
    parser_->header_limit(kHeaderBytesMax);
    parser_->body_limit(HttpRequestHandler::kBuildingBytesMax);
    beast::get_lowest_layer(stream_).expires_after(kTimeout);
    http::async_read_header(stream_, buffer_, *parser_,
                            [self = this->shared_from_this()](const beast::error_code& error, std::size_t) {
                              if (!error) self->on_header();
                            });
  }

 private:
  static std::string_view view(beast::string_view text) { return {text.data(), text.size()}; }

  Caller caller() const {
    const auto& request = parser_->get();
    return {.host = view(request[http::field::host]),
            .origin = view(request[http::field::origin]),
            .authorization = view(request[http::field::authorization]),
            .target = view(request.target())};
  }

  /// Refuses callers without access before reading any more.
  void on_header() {
    if (!server_context_.authenticator.is_from_here(caller()))
      return reply(http_problem(403, "a foreign Origin or Host"), false);
    if (beast::websocket::is_upgrade(parser_->get())) return upgrade();
    const HttpQuestion question = asked();
    if (HttpRequestHandler::brings_building(question.method, question.target)) {
      if (question.knows_token && question.has_lease) return read_body();
      return reply(server_context_.request_handler.answer(question), false);
    }
    const bool has_body = parser_->chunked() || parser_->content_length().value_or(0) > 0;
    reply(server_context_.request_handler.answer(question), !has_body && parser_->keep_alive());
  }

  void read_body() {
    http::async_read(stream_, buffer_, *parser_,
                     [self = this->shared_from_this()](const beast::error_code& error, std::size_t) {
                       if (error == http::error::body_limit)
                         return self->reply(http_problem(413, "more than 16 MiB"), false);
                       if (!error)
                         self->reply(self->server_context_.request_handler.answer(self->asked()),
                                     self->parser_->keep_alive());
                     });
  }

  HttpQuestion asked() {
    const auto& request = parser_->get();
    const std::string_view lease = view(request["X-Aisle-Lease"]);
    return {.method = view(request.method_string()),
            .target = view(request.target()),
            .body = request.body(),
            .knows_token = server_context_.authenticator.knows_token(caller()),
            .has_lease = !lease.empty() && server_context_.hub.lease().renew(lease),
            .takes_gzip = http::token_list(request[http::field::accept_encoding]).exists("gzip"),
            .known_tags = view(request[http::field::if_none_match])};
  }

  void upgrade() {
    if (!server_context_.authenticator.knows_token(caller()))
      return reply(http_problem(401, "the token is missing or wrong"), false);
    const auto subprotocol = known_subprotocol();
    if (!subprotocol) return reply(http_problem(400, "the subprotocol must be foxglove.websocket.v1"), false);
    beast::get_lowest_layer(stream_).expires_never();
    std::make_shared<WebSocketConnection<Stream>>(std::move(stream_), server_context_, std::move(connection_))
        ->accept(parser_->release(), *subprotocol);
  }

  std::optional<std::string> known_subprotocol() const {
    http::token_list offered(parser_->get()[http::field::sec_websocket_protocol]);
    for (const char* known : {"foxglove.websocket.v1", "foxglove.sdk.v1"}) {
      if (offered.exists(known)) return known;
    }
    return std::nullopt;
  }

  void reply(HttpReply reply, bool goes_on) {
    if (reply.file) return reply_file(reply, goes_on);
    http::response<http::string_body> response;
    response.body() = std::move(reply.body);
    send(std::move(response), reply, goes_on);
  }

  void reply_file(const HttpReply& reply, bool goes_on) {
    http::response<http::file_body> response;
    beast::error_code error;
    response.body().open(reply.file->c_str(), beast::file_mode::scan, error);
    if (error) return this->reply(http_problem(404, "there is no such file"), goes_on);
    send(std::move(response), reply, goes_on);
  }

  template <class Body>
  void send(http::response<Body> response, const HttpReply& reply, bool goes_on) {
    response.result(reply.status);
    response.set(http::field::server, "aisle");
    response.set(http::field::content_type, reply.media_type);
    response.set(http::field::cache_control,
                 reply.is_for_ever ? "public, max-age=31536000, immutable" : "no-cache");
    if (!reply.tag.empty()) response.set(http::field::etag, reply.tag);
    if (!reply.tag.empty()) response.set(http::field::vary, "Accept-Encoding");
    if (reply.is_gzip) response.set(http::field::content_encoding, "gzip");
    if (const auto origin = caller().origin; !origin.empty())
      response.set(http::field::access_control_allow_origin,
                   beast::string_view(origin.data(), origin.size()));
    response.set("X-Content-Type-Options", "nosniff");
    response.set("Referrer-Policy", "no-referrer");
    response.set(
        "Content-Security-Policy",
        "default-src 'self'; connect-src 'self' ws: wss:; img-src 'self' blob: data:; style-src 'self' "
        "'unsafe-inline'; worker-src 'self' blob:; frame-ancestors 'none'");
    response.keep_alive(goes_on);
    response.prepare_payload();
    beast::get_lowest_layer(stream_).expires_after(kTimeout);
    if (parser_->get().method() == http::verb::head) return send_head(std::move(response));
    const auto kept = std::make_shared<http::response<Body>>(std::move(response));
    http::async_write(stream_, *kept,
                      [self = this->shared_from_this(), kept](const beast::error_code& error, std::size_t) {
                        if (!error) self->on_sent(kept->keep_alive());
                      });
  }

  template <class Body>
  void send_head(http::response<Body> whole) {
    const auto head = std::make_shared<http::response<http::empty_body>>(std::move(whole.base()));
    const auto serializer = std::make_shared<http::response_serializer<http::empty_body>>(*head);
    http::async_write_header(
        stream_, *serializer,
        [self = this->shared_from_this(), head, serializer](const beast::error_code& error, std::size_t) {
          if (!error) self->on_sent(head->keep_alive());
        });
  }

  void on_sent(bool goes_on) {
    if (goes_on) return read();
    end_stream(stream_, this->shared_from_this());
  }

  Stream stream_;
  ServerContext& server_context_;
  Counted connection_;
  beast::flat_buffer buffer_;
  std::optional<http::request_parser<http::string_body>> parser_;
};

}  // namespace aisle::net
