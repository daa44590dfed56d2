#pragma once

#include <filesystem>

namespace aisle {

/// The server's certificate and key, both in PEM form; give both or neither.
struct TlsFiles {
  std::filesystem::path certificate;  ///< the server's own first, then the intermediate ones
  std::filesystem::path key;          ///< of the certificate, without a pass phrase

  bool are_given() const { return !certificate.empty() || !key.empty(); }
};

}  // namespace aisle
