#pragma once

#include <functional>
#include <iosfwd>
#include <string>

#include "aisle/commands/outcome.hpp"
#include "aisle/exploration/grid_rules.hpp"

namespace aisle {

struct MazeMmsOptions {
  GridRuleSet rules = GridRuleSet::kHoming;
  std::istream* replies = nullptr;   ///< from the simulator; must be set
  std::ostream* commands = nullptr;  ///< to the simulator; must be set
};

/// `aisle maze mms`: the explorer as a mouse of the mms simulator. It explores everything, comes back, then
/// drives the shortest known path to the middle. The simulator's reset button starts it again. The outcome is
/// not ok if a move ended at a wall or the middle cannot be reached. A simulator that ends, or replies
/// against the protocol, is a problem.
Result<Outcome> run_maze_mms(const MazeMmsOptions& options, Console& console);

}  // namespace aisle
