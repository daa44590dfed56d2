#pragma once

#include <filesystem>

#include "aisle/commands/outcome.hpp"
#include "aisle/commands/parameter_sources.hpp"

namespace aisle {

struct DiffOptions {
  std::filesystem::path old_building;  ///< building file (JSON), or a map of map_server (YAML)
  std::filesystem::path new_building;
  std::filesystem::path out;  ///< output directory of the pictures; empty: figures only
  bool force = false;
  ParameterSources parameters;
};

/// `aisle diff OLD NEW`: lays two maps of one building onto each other and says what has changed.
Result<Outcome> run_diff(const DiffOptions& options, Console& console);

/// Every parameter of `aisle diff` with its default.
Outcome diff_parameters();

}  // namespace aisle
