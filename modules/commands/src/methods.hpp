#pragma once

#include <string>

#include "aisle/core/problem.hpp"

namespace aisle {

/// Empty if there is such a method of learning and driving; else a problem that lists them.
Problems check_method(const std::string& method);

/// The vehicle that is asked for, else the one that the method was made for.
std::string vehicle_or_usual(const std::string& vehicle, const std::string& method);

}  // namespace aisle
