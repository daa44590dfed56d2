#pragma once

#include <string>

namespace aisle {

/// The text as a YAML scalar in double quotes.
std::string yaml_quoted(const std::string& text);

/// Whether `yaml_quoted` can write the text so that it reads back unchanged: UTF-8 without control
/// characters.
bool is_line_of_text(const std::string& text);

}  // namespace aisle
