#pragma once

#include "aisle/commands/outcome.hpp"
#include "aisle/trials/trial_options.hpp"

namespace aisle {

/// `aisle trial explore`: complete explorations, one per seed, judged by the ground truth. The outcome is ok
/// if every mission is complete.
Result<Outcome> run_exploration_trial(const TrialOptions& options, Console& console);

}  // namespace aisle
