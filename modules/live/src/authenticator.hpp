#pragma once

#include <string>
#include <string_view>

namespace aisle {

/// What a request says about who sends it.
struct Caller {
  std::string_view host;           ///< the Host header
  std::string_view origin;         ///< the Origin header; empty: none, no browser
  std::string_view authorization;  ///< the Authorization header
  std::string_view target;         ///< the address without scheme and host
};

/// Who is let in.
class Authenticator {
 public:
  /// @param is_local  only this machine is listened to
  /// @param token     that callers must know; empty: none is asked for
  Authenticator(bool is_local, std::string token);

  /// No page of another site, and no name that was pointed at this machine.
  bool is_from_here(const Caller& caller) const;
  bool knows_token(const Caller& caller) const;

 private:
  bool is_local_;
  std::string token_;
};

}  // namespace aisle
