#pragma once

#include <yaml-cpp/yaml.h>

#include <string>
#include <string_view>

#include "problem_list.hpp"

namespace aisle {

/// The first document of a YAML text. Each value takes some 300 bytes of memory, and each level of the stack:
/// more than 2 million values or 32 levels count as malformed.
/// @throws YAML::ParserException where the text is malformed
YAML::Node load_yaml(std::string_view text);

/// The text as a YAML scalar in double quotes.
std::string yaml_quoted(const std::string& text);

/// Whether `yaml_quoted` can write the text so that it reads back unchanged: UTF-8 without control
/// characters.
bool is_line_of_text(const std::string& text);

/// Whether a name may be part of a topic's name, as a camera's is: a letter, then letters, digits and _, at
/// most 64 of them.
bool is_topic_word(std::string_view name);

/// Adds a problem for every key that a map has twice: YAML readers differ in which of them they take.
void add_duplicate_keys(const YAML::Node& map, ProblemList& problems);

}  // namespace aisle
