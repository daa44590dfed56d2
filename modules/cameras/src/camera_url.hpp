#pragma once
/// Network addresses of cameras, which often hold a password.

#include <string>
#include <string_view>

namespace aisle {

struct CameraUrl {
  std::string location;  ///< without user and password
  std::string user;      ///< decoded; empty: none
  std::string password;
};

CameraUrl split_url(std::string_view url);

/// The text with every URL in it reduced to scheme, host and path. Rather too much is taken away than a part
/// of a password left.
std::string without_secrets(std::string_view text);

}  // namespace aisle
