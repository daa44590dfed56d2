#pragma once

#include <string>

#include "aisle/core/problem.hpp"

namespace aisle {

/// Empty if there is such a method of learning and driving; else a problem that lists them.
Problems check_method(const std::string& method);

}  // namespace aisle
