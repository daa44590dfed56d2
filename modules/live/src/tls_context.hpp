#pragma once

#include <boost/asio/ssl/context.hpp>

#include "aisle/core/result.hpp"
#include "aisle/live/tls_files.hpp"

namespace aisle {

/// The context that encrypts a server's connections: TLS 1.2 or newer.
Result<boost::asio::ssl::context> tls_context(const TlsFiles& files);

}  // namespace aisle
