#pragma once

#include "aisle/trials/trial_options.hpp"
#include "landmarks/landmark_course.hpp"
#include "mission_runs.hpp"

namespace aisle {

/// `trial landmarks`: routes taught once, then driven and refined as often as the options say.
Result<TrialResult> trial_by_landmarks(const TrialOptions& options, const LandmarkCourseParams& params,
                                       Console& console);

}  // namespace aisle
