#pragma once
/// The verbs of learning and driving with `--method sections` (L03).

#include "aisle/commands/learn.hpp"
#include "aisle/commands/navigate.hpp"
#include "aisle/commands/trial.hpp"
#include "sections/section_driver.hpp"
#include "sections/section_learning_result.hpp"

namespace aisle {

Result<Outcome> learn_by_sections(const LearnOptions& options, const SectionLearnerParams& params,
                                  Console& console);
Result<Outcome> navigate_by_sections(const NavigateOptions& options, const SectionDriverParams& params,
                                     Console& console);

struct SectionTrialParams {
  SectionLearnerParams learner;
  SectionNavigatorParams navigator;

  void describe(FieldList& fields) {
    fields.group("learner", learner);
    fields.group("navigator", navigator);
  }
};

Result<Outcome> trial_by_sections(const TrialOptions& options, const SectionTrialParams& params,
                                  Console& console);

}  // namespace aisle
