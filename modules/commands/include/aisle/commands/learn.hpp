#pragma once

#include "aisle/commands/learn_options.hpp"
#include "aisle/commands/outcome.hpp"

namespace aisle {

/// `aisle learn SESSION...`: learns a building from a taught run: the route and what it is driven by. The
/// method sections also learns from several runs along one route.
Result<Outcome> run_learn(const LearnOptions& options, Console& console);

/// Every parameter of `aisle learn` with its default.
Outcome learn_parameters();

}  // namespace aisle
