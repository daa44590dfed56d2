#pragma once

#include "aisle/commands/trial.hpp"

namespace aisle {

/// `aisle trial explore`: complete explorations, one per seed, judged by the ground truth. The outcome is ok
/// if every mission is complete.
Result<Outcome> run_exploration_trial(const TrialOptions& options, Console& console);

/// Share of the coverable floor that a complete mission has covered. The rest is corners behind which too
/// little floor lies to look for.
inline constexpr double kCompleteShare = 0.98;

}  // namespace aisle
