#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/stream_traits.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/ssl/ssl_stream.hpp>
#include <chrono>
#include <utility>

namespace aisle::net {

namespace beast = boost::beast;

using PlainStream = beast::tcp_stream;
using TlsStream = beast::ssl_stream<beast::tcp_stream>;

/// Time-out of operations that should complete at once.
inline constexpr std::chrono::seconds kShortTimeout{5};

/// Ends writing on the stream.
/// @param owner  kept alive until the other side has noticed
template <class Owner>
void end_stream(PlainStream& stream, const Owner&) {
  beast::error_code ignored;
  stream.socket().shutdown(boost::asio::ip::tcp::socket::shutdown_send, ignored);
}

template <class Owner>
void end_stream(TlsStream& stream, Owner owner) {
  beast::get_lowest_layer(stream).expires_after(kShortTimeout);
  stream.async_shutdown([kept = std::move(owner)](const beast::error_code&) {});
}

}  // namespace aisle::net
