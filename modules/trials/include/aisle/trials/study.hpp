#pragma once

#include <filesystem>
#include <vector>

#include "aisle/commands/outcome.hpp"
#include "aisle/formats/study_file.hpp"
#include "aisle/trials/trial_options.hpp"

namespace aisle {

struct StudyOptions {
  Study study;
  /// Of the study's variants, in their order; the same seeds for all, and a directory of its own for each.
  std::vector<TrialOptions> trials;
};

/// `aisle study FILE --out DIR`: runs each variant's trial, and compares it with the first one's over the
/// same seeds: how many missions went well, and the figures that the study names. Chances are adjusted for
/// the number of comparisons. The outcome is ok if all missions ended, well or not. Problem: a figure that no
/// mission has.
Result<Outcome> run_study(const StudyOptions& options, Console& console);

}  // namespace aisle
