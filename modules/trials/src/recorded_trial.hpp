#pragma once

#include "aisle/trials/trial_options.hpp"
#include "mission_runs.hpp"

namespace aisle {

/// `aisle trial` with the records of its missions.
Result<TrialResult> run_recorded_trial(const TrialOptions& options, Console& console);

}  // namespace aisle
