#include "aisle/exploration/exploration_run.hpp"

#include <algorithm>

#include "aisle/exploration/grid_explorer.hpp"
#include "aisle/exploration/known_paths.hpp"

namespace aisle {
namespace {

/// The world as a vehicle drives through it; counts its moves.
class Drive {
 public:
  Drive(const GridWorld& world, Cell start, KeepMoves keep, Progress& progress)
      : world_(world),
        at_(world.index(start)),
        start_(at_),
        reachable_(reachable_cells(world, start)),
        keep_(keep == KeepMoves::kYes),
        progress_(progress),
        uses_(2 * world.size(), 0) {
    figures_.reachable = static_cast<std::size_t>(std::count(reachable_.begin(), reachable_.end(), true));
  }

  std::size_t at() const { return at_; }
  Sides sense() const { return world_.open(at_); }

  void move(Side side) {
    count_use(side);
    at_ = world_.neighbour(at_, side);
    ++figures_.moves;
    if (keep_) moves_.push_back(side);
    if (figures_.moves % kReportedMoves == 0) {
      progress_.report("explore", std::min(figures_.moves, usual_moves()), usual_moves());
    }
  }

  /// No rule needs an edge more than four times, and there are fewer than two edges for each cell.
  bool has_gone_too_far() const { return figures_.moves > 16 * figures_.reachable; }

  Exploration finish(LearnedGrid map) && {
    for (std::size_t cell = 0; cell < world_.size(); ++cell) figures_.visited += map.visited(cell);
    figures_.max_edge_uses = *std::max_element(uses_.begin(), uses_.end());
    figures_.ended_at_start = at_ == start_;
    figures_.map_equals_truth = equals_truth(map);
    return {figures_, std::move(map), std::move(moves_)};
  }

  ExplorationFigures& figures() { return figures_; }

 private:
  static constexpr std::size_t kReportedMoves = 1 << 16;

  std::size_t usual_moves() const { return 3 * figures_.reachable; }

  /// An edge is counted at its left or bottom cell; the counter stops at its largest value.
  void count_use(Side side) {
    const bool upright = side == Side::kBottom || side == Side::kTop;
    const bool first = side == Side::kRight || side == Side::kTop;
    std::uint8_t& uses = uses_[2 * (first ? at_ : world_.neighbour(at_, side)) + upright];
    uses = static_cast<std::uint8_t>(uses + (uses < UINT8_MAX));
  }

  bool equals_truth(const LearnedGrid& map) const {
    for (std::size_t cell = 0; cell < world_.size(); ++cell) {
      if (map.visited(cell) != reachable_[cell]) return false;
      if (reachable_[cell] && map.open(cell) != world_.open(cell)) return false;
    }
    return true;
  }

  const GridWorld& world_;
  std::size_t at_;
  std::size_t start_;
  std::vector<bool> reachable_;
  bool keep_;
  Progress& progress_;
  std::vector<std::uint8_t> uses_;
  std::vector<Side> moves_;
  ExplorationFigures figures_;
};

}  // namespace

Exploration explore(const GridWorld& world, Cell start, const GridRules& rules, Progress& progress,
                    KeepMoves keep) {
  Drive drive(world, start, keep, progress);
  GridExplorer explorer(rules, world.width(), world.height(), start);
  const std::vector<Symbol>& stack = explorer.transducer().stack();
  std::size_t max_stack = 0;
  while (!drive.has_gone_too_far()) {
    const std::optional<Side> side = explorer.step(drive.sense());
    if (!side) break;
    max_stack = std::max(max_stack, stack.size() - 1);
    drive.move(*side);
  }
  drive.figures().halted = explorer.transducer().halted();
  drive.figures().max_stack = max_stack;
  drive.figures().stack_empty = stack.size() == 1 && stack.front() == kStackStart;
  return std::move(drive).finish(explorer.map());
}

Exploration explore_nearest_first(const GridWorld& world, Cell start, Progress& progress, KeepMoves keep) {
  Drive drive(world, start, keep, progress);
  LearnedGrid map(world.width(), world.height());
  KnownPaths paths;
  std::vector<Side> path;
  const auto unvisited_side = [&map](std::size_t cell) {
    return std::find_if(std::begin(kAllSides), std::end(kAllSides), [&](Side side) {
      return contains(map.open(cell), side) && !map.visited(map.neighbour(cell, side));
    });
  };
  const auto follow_path = [&] {
    for (; !path.empty(); path.pop_back()) drive.move(path.back());
  };
  while (true) {
    map.see(drive.at(), drive.sense());
    const auto edge = paths.search(map, drive.at(),
                                   [&](std::size_t c) { return unvisited_side(c) != std::end(kAllSides); });
    if (!edge) break;
    paths.take_path(map, *edge, path);
    follow_path();
    drive.move(*unvisited_side(*edge));
  }
  const std::size_t home = world.index(start);
  (void)paths.search(map, drive.at(), [home](std::size_t cell) { return cell == home; });
  paths.take_path(map, home, path);
  follow_path();
  drive.figures().halted = true;
  drive.figures().stack_empty = true;
  return std::move(drive).finish(std::move(map));
}

}  // namespace aisle
