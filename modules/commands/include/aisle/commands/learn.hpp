#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "aisle/commands/outcome.hpp"
#include "aisle/commands/parameter_sources.hpp"

namespace aisle {

struct LearnOptions {
  std::vector<std::filesystem::path> sessions;  ///< at least one; several only with the method sections
  std::string method = "landmarks";
  std::filesystem::path out;  ///< output directory; empty: figures only
  bool force = false;
  ParameterSources parameters;
};

/// `aisle learn SESSION...`: learns a building from a taught run: the route and what it is driven by. The
/// method sections also learns from several runs along one route.
Result<Outcome> run_learn(const LearnOptions& options, Console& console);

/// Every parameter of `aisle learn` with its default.
Outcome learn_parameters();

}  // namespace aisle
