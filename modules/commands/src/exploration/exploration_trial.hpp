#pragma once

#include "aisle/commands/trial.hpp"

namespace aisle {

/// `aisle trial explore`: whole explorations, one a seed, judged by the truth. The outcome is ok if every
/// mission is complete.
Result<Outcome> run_exploration_trial(const TrialOptions& options, Console& console);

/// How much of the floor that can be covered a complete mission has covered: what is left out are corners
/// behind which too little floor lies to look for.
inline constexpr double kCompleteShare = 0.98;

}  // namespace aisle
