#include "aisle/commands/mazes/maze_mms.hpp"

#include <algorithm>

#include "aisle/exploration/grid_explorer.hpp"
#include "aisle/exploration/known_paths.hpp"
#include "aisle/exploration/maze_generator.hpp"
#include "mazes/mms_mouse.hpp"

namespace aisle {
namespace {

constexpr char kExploredColor = 'B';
constexpr char kCrossingColor = 'o';
constexpr char kFastColor = 'G';

/// Thrown when the reset button was pressed.
struct Restart {};

class MmsMission {
 public:
  MmsMission(const MazeMmsOptions& options, Progress& progress)
      : options_(options), progress_(progress), mouse_(*options.replies, *options.commands) {}

  Result<Outcome> run() {
    try {
      const int width = mouse_.size("mazeWidth");
      const int height = mouse_.size("mazeHeight");
      while (!is_done(width, height)) ++figures_.resets;
    } catch (const MmsFailure& failure) {
      return Problem{{}, failure.what};
    } catch (const MmsCrash&) {
      figures_.crashed = true;
    }
    return report();
  }

 private:
  struct Figures {
    std::size_t cells = 0;
    std::size_t moves = 0;
    std::size_t path_to_middle = 0;
    std::size_t resets = 0;
    bool in_middle = false;
    bool crashed = false;
  };

  bool is_done(int width, int height) {
    try {
      GridExplorer explorer(grid_rules(options_.rules), width, height, mouse_.at());
      figures_.cells = figures_.moves = 0;
      explore(explorer);
      drive_to_middle(explorer.map());
      return true;
    } catch (const Restart&) {
      return false;
    }
  }

  void explore(GridExplorer& explorer) {
    while (true) {
      check_reset();
      const std::size_t at = explorer.at_index();
      const bool is_new = !explorer.map().visited(at);
      const Sides open = is_new ? mouse_.sense() : explorer.map().open(at);
      const auto side = explorer.step(open);
      if (is_new) mouse_.show(open, explorer.is_explored_crossing(at) ? kCrossingColor : kExploredColor);
      figures_.cells += is_new;
      if (!side) return;
      mouse_.move(*side);
      ++figures_.moves;
    }
  }

  /// Drives straight segments in one move: the simulator's score rewards them.
  void drive_to_middle(const LearnedGrid& map) {
    const std::vector<Cell> middle = middle_cells(map);
    KnownPaths paths;
    const auto goal = paths.search(map, map.index(mouse_.at()), [&](std::size_t cell) {
      return std::find(middle.begin(), middle.end(), map.cell(cell)) != middle.end();
    });
    figures_.in_middle = goal.has_value();
    if (!goal) return;
    std::vector<Side> path;
    paths.take_path(map, *goal, path);
    figures_.path_to_middle = path.size();
    while (!path.empty()) {
      check_reset();
      const Side side = path.back();
      int cells = 0;
      for (; !path.empty() && path.back() == side; path.pop_back()) ++cells;
      mouse_.move(side, cells);
      mouse_.show(kEverySide, kFastColor);
    }
    check_reset();
  }

  void check_reset() {
    progress_.report("explore", 0, 0);
    if (mouse_.take_reset()) throw Restart{};
  }

  Outcome report() const {
    Outcome outcome{.verb = "maze mms", .ok = figures_.in_middle && !figures_.crashed};
    outcome.figures = {{"rules", name_of(options_.rules)},
                       {"visited", figures_.cells},
                       {"moves", figures_.moves},
                       {"reached_middle", figures_.in_middle && !figures_.crashed},
                       {"way_to_middle", figures_.path_to_middle},
                       {"resets", figures_.resets},
                       {"crashed", figures_.crashed}};
    return outcome;
  }

  const MazeMmsOptions& options_;
  Progress& progress_;
  MmsMouse mouse_;
  Figures figures_;
};

}  // namespace

Result<Outcome> run_maze_mms(const MazeMmsOptions& options, Console& console) {
  return MmsMission(options, console.progress).run();
}

}  // namespace aisle
