#pragma once

#include "aisle/guidance/sections/section_navigator.hpp"
#include "aisle/missions/sections/section_learning_result.hpp"
#include "aisle/trials/trial_options.hpp"
#include "mission_runs.hpp"

namespace aisle {

struct SectionTrialParams {
  SectionLearnerParams learner;
  SectionNavigatorParams navigator;

  void describe(FieldList& fields) {
    fields.group("learner", learner);
    fields.group("navigator", navigator);
  }
};

/// `trial sections`: routes of corridors, taught and driven there and back.
Result<TrialResult> trial_by_sections(const TrialOptions& options, const SectionTrialParams& params,
                                      Console& console);

}  // namespace aisle
