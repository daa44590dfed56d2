#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "aisle/commands/outcome.hpp"
#include "aisle/exploration/grid_rules.hpp"

namespace aisle {

/// Where a run can be watched.
struct Terminal {
  int columns = 80;
  int rows = 24;
  std::function<void(const std::string&)> show;  ///< shows a frame and waits as long as it shall be seen
};

struct MazeExploreOptions {
  std::vector<std::string> files;
  GridRuleSet rules = GridRuleSet::kPublished;
  std::optional<Cell> start;  ///< none: what each file says
  bool compare = false;       ///< with the other rule sets, nearest frontier, and what no walk can undercut
  std::optional<std::filesystem::path> svg;  ///< an image of the run; for one maze
  std::optional<std::filesystem::path> gif;  ///< the same, moving
  bool force = false;                        ///< replace images that are there already
  std::optional<Terminal> watch;             ///< for one maze
};

/// `aisle maze explore`: explores every reachable cell of each maze and comes back. The outcome is not ok if
/// any was not explored as the rules promise.
Result<Outcome> run_maze_explore(const MazeExploreOptions& options, Console& console);

}  // namespace aisle
