#pragma once

#include "aisle/trials/trial_options.hpp"
#include "mission_runs.hpp"

namespace aisle {

/// `aisle trial localise`: a vehicle is put down at a random pose of a building that it knows, and not told
/// where. It drives carefully until it knows.
Result<TrialResult> run_localisation_trial(const TrialOptions& options, Console& console);

}  // namespace aisle
