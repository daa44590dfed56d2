#pragma once

#include <functional>
#include <iosfwd>
#include <string>

#include "aisle/commands/outcome.hpp"
#include "aisle/exploration/grid_rules.hpp"

namespace aisle {

struct MazeMmsOptions {
  GridRuleSet rules = GridRuleSet::kHoming;
  std::istream* replies = nullptr;   ///< what the simulator says
  std::ostream* commands = nullptr;  ///< what the mouse says
};

/// `aisle maze mms`: the explorer as a mouse of the mms simulator. It explores everything, comes back, then
/// drives the shortest known path to the middle; pressing the simulator's reset button begins it all again.
/// Not ok if a move ended at a wall or the middle cannot be reached. A simulator that goes away, or answers
/// nonsense, is a problem.
Result<Outcome> run_maze_mms(const MazeMmsOptions& options, Console& console);

}  // namespace aisle
