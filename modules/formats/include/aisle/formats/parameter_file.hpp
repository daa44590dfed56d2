#pragma once
/// Parameters in YAML: nested maps form dotted keys; see docs/formats/parameters.md.

#include <filesystem>
#include <string>
#include <string_view>

#include "aisle/core/parameters.hpp"

namespace aisle {

/// Assigns every value of the file to its field. Returns all problems together, each with file, line and key:
/// unknown keys, keys set twice, unreadable or out-of-range values. A field with a problem keeps its value.
/// Empty on success.
Problems read_parameters(const std::filesystem::path& path, FieldList& fields);

/// The same from memory; `name` is the file name in problems.
Problems parse_parameters(std::string_view text, const std::string& name, FieldList& fields);

/// All fields with their current values, each below a comment with its meaning and range. Reading the text
/// back assigns these values again.
std::string parameters_yaml(const FieldList& fields);

}  // namespace aisle
