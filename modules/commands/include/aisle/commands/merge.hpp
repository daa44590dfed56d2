#pragma once

#include <filesystem>
#include <vector>

#include "aisle/commands/outcome.hpp"
#include "aisle/commands/parameter_sources.hpp"

namespace aisle {

struct MergeOptions {
  std::vector<std::filesystem::path> buildings;  ///< at least two: building files, or maps of map_server
  std::filesystem::path out;                     ///< output directory; empty: figures only
  bool force = false;
  ParameterSources parameters;
};

/// `aisle merge BUILDING...`: makes one building of maps of its parts, whose frames are not known to each
/// other.
Result<Outcome> run_merge(const MergeOptions& options, Console& console);

/// Every parameter of `aisle merge` with its default.
Outcome merge_parameters();

}  // namespace aisle
