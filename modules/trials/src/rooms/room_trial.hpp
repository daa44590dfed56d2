#pragma once

#include "aisle/trials/trial_options.hpp"
#include "mission_runs.hpp"
#include "rooms/room_trial_params.hpp"

namespace aisle {

/// `trial rooms`: routes of a world with moved furniture and changed light.
Result<TrialResult> trial_by_route(const TrialOptions& options, const RoomTrialParams& params,
                                   Console& console);
/// `trial turnings`: the thirteen turnings, each in its own room, or pairs that are too close.
Result<TrialResult> trial_of_turnings(const TrialOptions& options, const RoomTrialParams& params,
                                      Console& console);
/// `trial park`: parking at the ends of routes, from disturbed starts.
Result<TrialResult> trial_of_parking(const TrialOptions& options, const RoomTrialParams& params,
                                     Console& console);

}  // namespace aisle
