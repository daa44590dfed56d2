#pragma once

#include "aisle/commands/navigate_options.hpp"
#include "aisle/commands/outcome.hpp"

namespace aisle {

/// `aisle navigate BUILDING --world WORLD`: drives a learned route autonomously, in the simulator or
/// with a robot. The outcome
/// is ok if the vehicle arrived without a collision.
Result<Outcome> run_navigate(const NavigateOptions& options, Console& console);

/// Every parameter of `aisle navigate` with its default.
Outcome navigate_parameters();

}  // namespace aisle
