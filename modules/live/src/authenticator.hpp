#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace aisle {

/// What a request says about its sender.
struct Caller {
  std::string_view host;           ///< the Host header
  std::string_view origin;         ///< the Origin header; empty: none, so not a browser
  std::string_view authorization;  ///< the Authorization header
  std::string_view target;         ///< the address without scheme and host
};

/// Whether the text is the origin of a page: "https://viewer.example", "http://localhost:8080".
bool is_origin(std::string_view text);

/// Decides which requests are accepted.
class Authenticator {
 public:
  /// @param is_local  only this machine can connect
  /// @param token     that callers must present; empty: none is required
  /// @param origins   other sites whose pages may connect, such as "https://viewer.example"
  Authenticator(bool is_local, std::string token, std::vector<std::string> origins = {});

  /// Refuses pages of sites that are not allowed, and foreign host names that were pointed at this machine
  /// (DNS rebinding).
  bool is_from_here(const Caller& caller) const;
  bool knows_token(const Caller& caller) const;

 private:
  bool is_local_;
  std::string token_;
  std::vector<std::string> origins_;
};

}  // namespace aisle
