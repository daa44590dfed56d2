#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "aisle/commands/outcome.hpp"
#include "aisle/exploration/grid_rules.hpp"

namespace aisle {

/// A terminal that shows a run.
struct Terminal {
  int columns = 80;
  int rows = 24;
  std::function<void(const std::string&)> show;  ///< shows a frame, returns when the next is due
};

struct MazeExploreOptions {
  std::vector<std::string> files;
  GridRuleSet rules = GridRuleSet::kPublished;
  std::optional<Cell> start;  ///< none: from each file
  bool compare = false;       ///< with the other rule sets, nearest frontier and the lower bound
  std::optional<std::filesystem::path> svg;  ///< file for a picture of the run; one maze only
  std::optional<std::filesystem::path> gif;  ///< file for the same as an animation
  bool force = false;                        ///< overwrite existing images
  std::optional<Terminal> watch;             ///< one maze only
};

/// `aisle maze explore`: explores every reachable cell of each maze and returns to its start. The outcome is
/// ok if every maze was explored as the rules promise.
Result<Outcome> run_maze_explore(const MazeExploreOptions& options, Console& console);

}  // namespace aisle
