#pragma once

#include "aisle/commands/explore_options.hpp"
#include "aisle/commands/outcome.hpp"

namespace aisle {

/// `aisle explore WORLD`: explores an unknown building in the simulator, comes home and keeps its map. The
/// outcome is ok if the exploration earned its certificate.
Result<Outcome> run_explore(const ExploreOptions& options, Console& console);

/// Every parameter of `aisle explore` with its default.
Outcome explore_parameters();

}  // namespace aisle
