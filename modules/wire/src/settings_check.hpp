#pragma once

#include <string>
#include <vector>

#include "aisle/core/problem.hpp"
#include "aisle/wire/wire.hpp"

namespace aisle {

/// The IPv4 addresses of this machine's interfaces that are up.
std::vector<std::string> own_addresses();

/// Everything that is wrong with the settings on a machine that has these addresses.
Problems check_settings(const WireSettings& settings, const std::vector<std::string>& own);

}  // namespace aisle
