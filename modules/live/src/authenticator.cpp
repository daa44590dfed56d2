#include "authenticator.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

#include "aisle/live/driver_lease.hpp"
#include "web_address.hpp"

namespace aisle {
namespace {

constexpr std::string_view kBearer = "Bearer ";

std::string_view without_port(std::string_view host) {
  const std::size_t colon = host.find_last_of(':');
  const bool is_port = colon != std::string_view::npos && host.find(']', colon) == std::string_view::npos;
  return is_port ? host.substr(0, colon) : host;
}

std::string_view without_scheme(std::string_view origin) {
  const std::size_t end = origin.find("://");
  return end == std::string_view::npos ? std::string_view{} : origin.substr(end + 3);
}

bool equal_names(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

}  // namespace

bool is_origin(std::string_view text) {
  const std::string_view host = without_scheme(text);
  const bool is_web = text.starts_with("http://") || text.starts_with("https://");
  return is_web && !host.empty() && host.find_first_of("/?#*@ ") == std::string_view::npos;
}

Authenticator::Authenticator(bool is_local, std::string token, std::vector<std::string> origins)
    : is_local_(is_local), token_(std::move(token)), origins_(std::move(origins)) {}

bool Authenticator::is_from_here(const Caller& caller) const {
  if (caller.host.empty()) return false;
  if (is_local_) {
    const std::string_view name = without_port(caller.host);
    if (!equal_names(name, "localhost") && name != "127.0.0.1" && name != "[::1]") return false;
  }
  const auto is_caller = [&](const std::string& origin) { return equal_names(origin, caller.origin); };
  return caller.origin.empty() || equal_names(without_scheme(caller.origin), caller.host) ||
         std::any_of(origins_.begin(), origins_.end(), is_caller);
}

bool Authenticator::knows_token(const Caller& caller) const {
  if (token_.empty()) return true;
  if (caller.authorization.starts_with(kBearer))
    return equal_secrets(caller.authorization.substr(kBearer.size()), token_);
  return equal_secrets(query_value(caller.target, "token"), token_);
}

}  // namespace aisle
