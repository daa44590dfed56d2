#pragma once
/// The verbs of learning and driving with `--method sections` (L03).

#include "aisle/commands/learn_options.hpp"
#include "aisle/commands/navigate_options.hpp"
#include "aisle/commands/outcome.hpp"
#include "aisle/missions/sections/section_driver.hpp"
#include "aisle/missions/sections/section_learning_result.hpp"

namespace aisle {

Result<Outcome> learn_by_sections(const LearnOptions& options, const SectionLearnerParams& params,
                                  Console& console);
Result<Outcome> navigate_by_sections(const NavigateOptions& options, const SectionDriverParams& params,
                                     Console& console);

}  // namespace aisle
