#pragma once

#include <optional>
#include <string>
#include <vector>

namespace aisle {

/// The IPv4 addresses of this machine.
std::vector<std::string> own_addresses();

/// The IPv4 address of a host: "robot.local", "192.168.1.7"; nullopt: it is not known.
std::optional<std::string> address_of(const std::string& host);

}  // namespace aisle
