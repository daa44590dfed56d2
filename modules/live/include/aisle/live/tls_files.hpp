#pragma once

#include <filesystem>

namespace aisle {

/// By what a server proves who it is, both in PEM form; both or neither.
struct TlsFiles {
  std::filesystem::path certificate;  ///< the server's own first, then those that vouch for it
  std::filesystem::path key;          ///< of the certificate, without a pass phrase

  bool are_given() const { return !certificate.empty() || !key.empty(); }
};

}  // namespace aisle
