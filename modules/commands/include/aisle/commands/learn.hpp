#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "aisle/commands/outcome.hpp"
#include "aisle/commands/parameter_sources.hpp"

namespace aisle {

struct LearnOptions {
  std::vector<std::filesystem::path> sessions;  ///< at least one; several for sections alone
  std::string method = "landmarks";
  std::filesystem::path out;  ///< empty: figures only
  bool force = false;
  ParameterSources parameters;
};

/// `aisle learn SESSION...`: a building with the route and what it is driven by, from a run that was
/// taught; of sections also from several runs along one way.
Result<Outcome> run_learn(const LearnOptions& options, Console& console);

/// Every parameter of `aisle learn` with its default.
Outcome learn_parameters();

}  // namespace aisle
