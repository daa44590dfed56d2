#pragma once

#include "aisle/trials/trial_options.hpp"
#include "mission_runs.hpp"

namespace aisle {

/// `aisle trial explore`: complete explorations, one per seed, judged by the ground truth. The outcome is ok
/// if every mission is complete.
Result<TrialResult> run_exploration_trial(const TrialOptions& options, Console& console);

}  // namespace aisle
