#pragma once

#include "aisle/trials/trial.hpp"

namespace aisle {

/// `aisle trial explore`: complete explorations, one per seed, judged by the ground truth. The outcome is ok
/// if every mission is complete.
Result<Outcome> run_exploration_trial(const TrialOptions& options, Console& console);

}  // namespace aisle
