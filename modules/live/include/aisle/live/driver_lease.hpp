#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "aisle/core/clock.hpp"

namespace aisle {

/// Identifies one connection while the server runs; 0 is none.
using ClientId = std::uint64_t;

/// Who may drive: one client at a time, as long as it keeps renewing its lease.
class DriverLease {
 public:
  static constexpr double kValid_s = 3;

  /// @param clock       must outlive the lease
  /// @param make_token  must return something that nobody can guess
  DriverLease(const Clock& clock, std::function<std::string()> make_token);

  /// @return the token; nullopt while another client holds the lease
  std::optional<std::string> take(ClientId client);

  /// @return whether this token is the valid lease; if so, it is valid for another kValid_s
  bool renew(std::string_view token);

  void release(std::string_view token);
  /// Call when the client's connection has ended.
  void gone(ClientId client);

  bool is_held() const;
  bool is_held_by_another(ClientId client) const { return is_held() && holder_ != client; }
  /// Grows with every lease that is granted.
  std::uint64_t number() const { return number_; }

 private:
  const Clock& clock_;
  std::function<std::string()> make_token_;
  ClientId holder_ = 0;
  std::string token_;
  double until_s_ = 0;
  std::uint64_t number_ = 0;
};

/// Compares in a time that does not depend on where they differ.
bool equal_secrets(std::string_view a, std::string_view b);

/// 128 random bits as hexadecimal digits.
std::string chance_token();

}  // namespace aisle
