#pragma once
/// The experiments of `aisle reproduce`, one per paper.

#include "aisle/trials/reproduce_options.hpp"
#include "landmarks/landmark_course.hpp"
#include "sections/section_trial.hpp"

namespace aisle {

Result<Outcome> reproduce_c98(const ReproduceOptions& options, const LandmarkCourseParams& params,
                              Console& console);
Result<Outcome> reproduce_c99(const ReproduceOptions& options, Console& console);
Result<Outcome> reproduce_l03(const ReproduceOptions& options, const SectionTrialParams& params,
                              Console& console);

}  // namespace aisle
