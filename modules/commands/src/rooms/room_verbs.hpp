#pragma once
/// The verbs of learning and driving with `--method rooms` (L96).

#include "aisle/commands/learn_options.hpp"
#include "aisle/commands/navigate_options.hpp"
#include "aisle/commands/outcome.hpp"
#include "aisle/missions/rooms/room_driver.hpp"
#include "aisle/missions/rooms/room_learning_result.hpp"

namespace aisle {

Result<Outcome> learn_by_route(const LearnOptions& options, const RoomLearnerParams& params,
                               Console& console);
Result<Outcome> navigate_by_route(const NavigateOptions& options, const RoomDriverParams& params,
                                  Console& console);

}  // namespace aisle
