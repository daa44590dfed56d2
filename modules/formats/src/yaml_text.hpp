#pragma once

#include <string>

namespace aisle {

/// The text as a YAML scalar in double quotes.
std::string yaml_quoted(const std::string& text);

/// Whether it can be written by `yaml_quoted` and read back as it was: UTF-8, without control characters.
bool is_line_of_text(const std::string& text);

}  // namespace aisle
