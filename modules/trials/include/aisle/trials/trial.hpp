#pragma once

#include <string_view>
#include <vector>

#include "aisle/commands/outcome.hpp"
#include "aisle/trials/trial_options.hpp"

namespace aisle {

/// `aisle trial METHOD --seeds A..B`: runs complete simulated missions, one per seed: teach, learn, drive
/// autonomously, refine. The outcome is ok if every mission arrived without a collision.
Result<Outcome> run_trial(const TrialOptions& options, Console& console);

/// What can be tried: the METHODs.
std::vector<std::string_view> trial_methods();

/// Every parameter of `aisle trial` with its default.
Outcome trial_parameters();

}  // namespace aisle
