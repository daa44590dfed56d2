#pragma once
/// The progress of an exploration over the driven distance. SVG documents; same record, same bytes.

#include <string>

#include "aisle/exploration/exploration_record.hpp"

namespace aisle {

/// The known floor area over the distance.
std::string coverage_svg(const ExplorationRecord& record);

/// The transducer's states over the distance, and below them the number of symbols on its stack.
std::string transducer_svg(const ExplorationRecord& record);

}  // namespace aisle
