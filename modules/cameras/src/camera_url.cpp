#include "camera_url.hpp"

#include <algorithm>
#include <charconv>

namespace aisle {
namespace {

constexpr std::string_view kAfterScheme = "://";

std::string percent_decoded(std::string_view text) {
  std::string decoded;
  while (!text.empty()) {
    unsigned byte = 0;
    if (text.front() == '%' && text.size() > 2 &&
        std::from_chars(text.data() + 1, text.data() + 3, byte, 16).ptr == text.data() + 3) {
      decoded += static_cast<char>(byte);
      text.remove_prefix(3);
    } else {
      decoded += text.front();
      text.remove_prefix(1);
    }
  }
  return decoded;
}

/// Host and path of the URL whose part behind the scheme this is. With an @ behind a ? it is either a
/// password or a query that is not encoded as it should.
std::string shown_address(std::string_view address) {
  const auto query = address.find_first_of("?#");
  if (const auto at = address.rfind('@'); at != std::string_view::npos) {
    if (query < at) return "...";
    address.remove_prefix(at + 1);
  }
  const auto shown = address.substr(0, address.find_first_of("?#"));
  return std::string(shown) + (shown.size() == address.size() ? "" : "?...");
}

}  // namespace

CameraUrl split_url(std::string_view url) {
  const auto begin = url.find(kAfterScheme) + kAfterScheme.size();
  const std::string_view authority = url.substr(begin, url.find_first_of("/?#", begin) - begin);
  const auto at = authority.rfind('@');
  if (at == std::string_view::npos) return {.location = std::string(url), .user = {}, .password = {}};
  const std::string_view user_and_password = authority.substr(0, at);
  const auto colon = std::min(user_and_password.find(':'), at);
  return {.location = std::string(url.substr(0, begin)).append(url.substr(begin + at + 1)),
          .user = percent_decoded(user_and_password.substr(0, colon)),
          .password = percent_decoded(user_and_password.substr(std::min(colon + 1, at)))};
}

std::string without_secrets(std::string_view text) {
  std::string shown;
  for (auto found = text.find(kAfterScheme); found != std::string_view::npos;
       found = text.find(kAfterScheme)) {
    const auto begin = found + kAfterScheme.size();
    const auto end = std::min(text.find_first_of(" \t\r\n", begin), text.size());
    shown.append(text.substr(0, begin)).append(shown_address(text.substr(begin, end - begin)));
    text.remove_prefix(end);
  }
  return shown.append(text);
}

}  // namespace aisle
