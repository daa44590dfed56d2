#pragma once

#include <boost/asio/ssl/context.hpp>
#include <boost/beast/core/detect_ssl.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http.hpp>
#include <memory>
#include <optional>
#include <utility>

#include "http_connection.hpp"
#include "streams.hpp"

namespace aisle::net {

/// A new connection before its TLS handshake. A client that speaks plain HTTP gets an error reply; anything
/// else that is not TLS is dropped.
class TlsHandshake : public std::enable_shared_from_this<TlsHandshake> {
 public:
  TlsHandshake(PlainStream stream, boost::asio::ssl::context& tls, ServerContext& server_context)
      : stream_(std::move(stream)),
        tls_(tls),
        server_context_(server_context),
        connection_(server_context.connections) {}

  void start() {
    stream_.expires_after(kShortTimeout);
    beast::async_detect_ssl(stream_, buffer_,
                            [self = this->shared_from_this()](const beast::error_code& error, bool is_tls) {
                              if (!error) is_tls ? self->handshake() : self->refuse();
                            });
  }

 private:
  void handshake() {
    encrypted_.emplace(std::move(stream_), tls_);
    encrypted_->async_handshake(
        boost::asio::ssl::stream_base::server, buffer_.data(),
        [self = this->shared_from_this()](const beast::error_code& error, std::size_t) {
          if (!error) self->accept();
        });
  }

  void accept() {
    std::make_shared<HttpConnection<TlsStream>>(std::move(*encrypted_), server_context_,
                                                std::move(connection_))
        ->read();
  }

  void refuse() {
    const HttpReply reply = http_problem(400, "this server only accepts https and wss");
    refusal_.result(reply.status);
    refusal_.set(http::field::content_type, reply.media_type);
    refusal_.body() = reply.body;
    refusal_.keep_alive(false);
    refusal_.prepare_payload();
    http::async_write(stream_, refusal_,
                      [self = this->shared_from_this()](const beast::error_code& error, std::size_t) {
                        if (!error) end_stream(self->stream_, self);
                      });
  }

  PlainStream stream_;
  boost::asio::ssl::context& tls_;
  ServerContext& server_context_;
  Counted connection_;
  beast::flat_buffer buffer_;
  std::optional<TlsStream> encrypted_;
  http::response<http::string_body> refusal_;
};

}  // namespace aisle::net
