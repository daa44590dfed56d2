#pragma once

#include "aisle/commands/outcome.hpp"
#include "aisle/commands/teach_options.hpp"

namespace aisle {

/// `aisle teach WORLD`: a person drives a route once, and the session records what the method learns from.
Result<Outcome> run_teach(const TeachOptions& options, Console& console);

}  // namespace aisle
