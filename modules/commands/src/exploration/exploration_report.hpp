#pragma once

#include <string>

#include "aisle/commands/outcome.hpp"
#include "aisle/maps/building.hpp"
#include "aisle/report/exploration_picture.hpp"

namespace aisle {

/// HTML page about an exploration: map and path, graph of corridors, known floor over the distance travelled,
/// the transducer's states and stack, figures, and what went wrong.
std::string exploration_report(const ExplorationPicture& picture, const Building& building,
                               const Outcome& outcome);

}  // namespace aisle
