#pragma once

#include <string>

#include "aisle/core/problem.hpp"

namespace aisle {

/// Empty if a building can have a route of this name.
/// @param where  that gave the name
Problems check_route_name(const Place& where, const std::string& name);

}  // namespace aisle
