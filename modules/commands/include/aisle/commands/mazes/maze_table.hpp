#pragma once

#include "aisle/commands/outcome.hpp"
#include "aisle/exploration/grid_rules.hpp"

namespace aisle {

enum class MazeTableFormat { kText, kJson, kDot, kSvg };

struct MazeTableOptions {
  GridRuleSet rules = GridRuleSet::kPublished;
  MazeTableFormat format = MazeTableFormat::kText;
};

/// `aisle maze table`: lists every transition and output rule of a rule set, and marks those that no world
/// leads to. kDot is the state diagram for Graphviz, with super rules at its edges; kSvg draws the input
/// symbols.
Result<Outcome> run_maze_table(const MazeTableOptions& options, Console& console);

}  // namespace aisle
