#pragma once

#include <filesystem>
#include <string>

#include "aisle/commands/outcome.hpp"

namespace aisle {

struct CompareOptions {
  std::filesystem::path trajectory;  ///< TUM or CSV
  std::filesystem::path truth;       ///< TUM, CSV or a bag
  std::string topic;                 ///< of the true poses in a bag; empty: the only one
  double step_m = 1;                 ///< relative errors are over pieces of the path that are this long
  std::filesystem::path out;         ///< output directory; empty: figures only
  bool force = false;
};

/// `aisle compare TRAJECTORY TRUTH`: lays a trajectory onto true poses and says how far it is off.
Result<Outcome> run_compare(const CompareOptions& options, Console& console);

}  // namespace aisle
