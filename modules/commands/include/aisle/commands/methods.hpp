#pragma once

#include <string>

#include "aisle/core/problem.hpp"

namespace aisle {

/// Empty if this method of learning and driving exists; else a problem that lists the methods.
Problems check_method(const std::string& method);

/// The requested vehicle; if empty, the method's default.
std::string vehicle_or_usual(const std::string& vehicle, const std::string& method);

}  // namespace aisle
