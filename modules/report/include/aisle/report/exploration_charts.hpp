#pragma once
/// How an exploration went, over the path that was driven. SVG documents; same record, same bytes.

#include <string>

#include "aisle/exploration/exploration_record.hpp"

namespace aisle {

/// Floor that was known after so much distance.
std::string coverage_svg(const ExplorationRecord& record);

/// The transducer's states one after the other, and below them how many paths waited on its stack.
std::string transducer_svg(const ExplorationRecord& record);

}  // namespace aisle
