#pragma once

#include <filesystem>
#include <string>

#include "aisle/commands/outcome.hpp"
#include "aisle/commands/parameter_sources.hpp"

namespace aisle {

struct LearnOptions {
  std::filesystem::path session;
  std::string method = "landmarks";
  std::filesystem::path out;  ///< empty: figures only
  bool force = false;
  ParameterSources parameters;
};

/// `aisle learn SESSION`: a building with its landmarks and the route, from a trip that was taught.
Result<Outcome> run_learn(const LearnOptions& options, Console& console);

/// Every parameter of `aisle learn` with its default.
Outcome learn_parameters();

}  // namespace aisle
