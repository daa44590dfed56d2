#include "tls_context.hpp"

#include <fmt/format.h>
#include <openssl/err.h>
#include <openssl/ssl.h>
#include <openssl/x509err.h>

#include <boost/asio/buffer.hpp>
#include <utility>

#include "aisle/formats/whole_file.hpp"

namespace aisle {
namespace {

namespace ssl = boost::asio::ssl;
using Error = boost::system::error_code;

constexpr std::size_t kPemBytesMax = 1 << 20;

bool is_of_another_certificate(const Error& error) {
  return ERR_GET_REASON(static_cast<unsigned long>(error.value())) == X509_R_KEY_VALUES_MISMATCH;
}

Problems use_certificate(ssl::context& context, const TlsFiles& files) {
  const auto pem = read_whole_file(files.certificate, kPemBytesMax);
  if (!pem) return pem.problems();
  Error error;
  context.use_certificate_chain(boost::asio::buffer(*pem), error);
  if (!error) return {};
  return {{{files.certificate.string()}, "contains no certificate in PEM form: " + error.message()}};
}

/// Call after loading the certificate: the key must match it.
Problems use_key(ssl::context& context, const TlsFiles& files) {
  const auto pem = read_whole_file(files.key, kPemBytesMax);
  if (!pem) return pem.problems();
  Error error;
  context.use_private_key(boost::asio::buffer(*pem), ssl::context::pem, error);
  const bool is_another =
      error ? is_of_another_certificate(error) : SSL_CTX_check_private_key(context.native_handle()) != 1;
  ERR_clear_error();
  if (is_another)
    return {{{files.key.string()},
             fmt::format("does not belong to the certificate in {}", files.certificate.string())}};
  if (!error) return {};
  return {{{files.key.string()},
           "contains no private key in PEM form, or one with a pass phrase: " + error.message()}};
}

}  // namespace

Result<ssl::context> tls_context(const TlsFiles& files) {
  if (files.certificate.empty() || files.key.empty())
    return Problem{{files.key.empty() ? "--key" : "--cert"}, "is missing: --cert and --key go together"};
  ssl::context context(ssl::context::tls_server);
  context.set_options(ssl::context::default_workarounds | ssl::context::no_compression |
                      SSL_OP_NO_RENEGOTIATION);
  SSL_CTX_set_min_proto_version(context.native_handle(), TLS1_2_VERSION);
  context.set_password_callback([](std::size_t, ssl::context::password_purpose) { return std::string(); });
  if (Problems problems = use_certificate(context, files); !problems.empty()) return problems;
  if (Problems problems = use_key(context, files); !problems.empty()) return problems;
  return context;
}

}  // namespace aisle
