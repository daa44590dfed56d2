#include "aisle/live/driver_lease.hpp"

#include <fmt/format.h>

#include <random>
#include <utility>

namespace aisle {

DriverLease::DriverLease(const Clock& clock, std::function<std::string()> make_token)
    : clock_(clock), make_token_(std::move(make_token)) {}

std::optional<std::string> DriverLease::take(ClientId client) {
  if (is_held() && holder_ != client) return std::nullopt;
  holder_ = client;
  token_ = make_token_();
  until_s_ = clock_.now_s() + kValid_s;
  ++number_;
  return token_;
}

bool DriverLease::renew(std::string_view token) {
  if (!is_held() || !equal_secrets(token, token_)) return false;
  until_s_ = clock_.now_s() + kValid_s;
  return true;
}

void DriverLease::release(std::string_view token) {
  if (is_held() && equal_secrets(token, token_)) holder_ = 0;
}

void DriverLease::gone(ClientId client) {
  if (holder_ == client) holder_ = 0;
}

bool DriverLease::is_held() const {
  return holder_ != 0 && clock_.now_s() < until_s_;
}

bool equal_secrets(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned different = 0;
  for (std::size_t i = 0; i < a.size(); ++i) different |= static_cast<unsigned char>(a[i] ^ b[i]);
  return different == 0;
}

std::string chance_token() {
  std::random_device device;
  std::string token;
  for (int i = 0; i < 4; ++i) token += fmt::format("{:08x}", device());
  return token;
}

}  // namespace aisle
