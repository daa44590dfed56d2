#pragma once

#include <string>

namespace aisle {

/// The text as a YAML scalar in double quotes.
std::string yaml_quoted(const std::string& text);

}  // namespace aisle
