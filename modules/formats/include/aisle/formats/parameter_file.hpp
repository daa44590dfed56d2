#pragma once
/// Parameters in YAML: nested maps stand for dotted keys; see docs/formats/parameters.md.

#include <filesystem>
#include <string>
#include <string_view>

#include "aisle/core/parameters.hpp"

namespace aisle {

/// Assigns every value of the file to its field. All problems at once, each with file, line and key: unknown
/// keys, keys set twice, unreadable or out-of-range values. Fields that have a problem keep their value.
/// Empty on success.
Problems read_parameters(const std::filesystem::path& path, FieldList& fields);

/// The same from memory; `name` stands for the file in problems.
Problems parse_parameters(std::string_view text, const std::string& name, FieldList& fields);

/// All fields with their present values, each after a comment with its meaning and range. Reading it back
/// assigns the values that it shows.
std::string parameters_yaml(const FieldList& fields);

}  // namespace aisle
