#pragma once
/// The verbs of learning and driving with `--method landmarks` (C98).

#include "aisle/commands/learn_options.hpp"
#include "aisle/commands/navigate_options.hpp"
#include "aisle/commands/outcome.hpp"
#include "aisle/guidance/landmarks/landmark_navigator.hpp"
#include "aisle/missions/landmarks/landmark_learning_result.hpp"

namespace aisle {

Result<Outcome> learn_by_landmarks(const LearnOptions& options, const LandmarkLearnerParams& params,
                                   Console& console);
Result<Outcome> navigate_by_landmarks(const NavigateOptions& options, const LandmarkNavigatorParams& params,
                                      Console& console);

}  // namespace aisle
