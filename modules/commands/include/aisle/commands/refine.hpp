#pragma once

#include <filesystem>
#include <vector>

#include "aisle/commands/outcome.hpp"
#include "aisle/commands/parameter_sources.hpp"

namespace aisle {

struct RefineOptions {
  std::filesystem::path building;
  std::vector<std::filesystem::path> sessions;  ///< runs along the building's routes, taken in this order
  std::filesystem::path out;                    ///< output directory; empty: figures only
  bool force = false;
  ParameterSources parameters;
};

/// `aisle refine BUILDING SESSION...`: refines a building's landmarks with more runs (C98 Algorithm 4).
Result<Outcome> run_refine(const RefineOptions& options, Console& console);

/// Every parameter of `aisle refine` with its default.
Outcome refine_parameters();

}  // namespace aisle
