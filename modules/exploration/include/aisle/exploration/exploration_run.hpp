#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "aisle/core/progress.hpp"
#include "aisle/exploration/grid_rules.hpp"

namespace aisle {

/// What one exploration came to, judged with the truth at hand.
struct ExplorationFigures {
  std::size_t reachable = 0;
  std::size_t visited = 0;
  std::size_t moves = 0;
  std::size_t max_edge_uses = 0;
  std::size_t max_stack = 0;  ///< most symbols above Z_0
  bool halted = false;        ///< false: given up, the rules went on far beyond what they may need
  bool ended_at_start = false;
  bool stack_empty = false;       ///< nothing but Z_0
  bool map_equals_truth = false;  ///< of the reachable part

  double coverage() const { return static_cast<double>(visited) / static_cast<double>(reachable); }
  /// 2 (C - 1): what a walk with return through the C reachable cells takes at least where they form a tree.
  std::size_t tree_moves() const { return 2 * (reachable - 1); }
  bool complete() const {
    return visited == reachable && halted && ended_at_start && stack_empty && map_equals_truth;
  }
};

struct Exploration {
  ExplorationFigures figures;
  LearnedGrid map;
  std::vector<Side> moves;  ///< all of them, if they were asked for
};

enum class KeepMoves { kNo, kYes };

/// A vehicle explores the world from `start` by the rules, seeing its own cell only.
Exploration explore(const GridWorld& world, Cell start, const GridRules& rules, Progress& progress,
                    KeepMoves keep = KeepMoves::kNo);

/// The baseline: always to the nearest cell that was seen but not visited, by known paths; at last to the
/// start. The same sensor. There is no stack: max_stack is 0.
Exploration explore_nearest_first(const GridWorld& world, Cell start, Progress& progress,
                                  KeepMoves keep = KeepMoves::kNo);

}  // namespace aisle
