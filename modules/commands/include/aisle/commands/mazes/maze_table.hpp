#pragma once

#include "aisle/commands/outcome.hpp"
#include "aisle/exploration/grid_rules.hpp"

namespace aisle {

enum class MazeTableFormat { kText, kJson, kDot, kSvg };

struct MazeTableOptions {
  GridRuleSet rules = GridRuleSet::kPublished;
  MazeTableFormat format = MazeTableFormat::kText;
};

/// `aisle maze table`: every transition and output rule of a rule set, those that no world leads to marked as
/// such. kDot is the diagram of the states for Graphviz, its edges labelled by super rules; kSvg shows the
/// input symbols.
Result<Outcome> run_maze_table(const MazeTableOptions& options, Console& console);

}  // namespace aisle
