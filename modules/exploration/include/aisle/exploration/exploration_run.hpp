#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "aisle/core/progress.hpp"
#include "aisle/exploration/grid_rules.hpp"

namespace aisle {

/// The result of one exploration, judged against the true world.
struct ExplorationFigures {
  std::size_t reachable = 0;
  std::size_t visited = 0;
  std::size_t moves = 0;
  std::size_t max_edge_uses = 0;
  std::size_t max_stack = 0;  ///< most symbols above Z_0
  bool halted = false;        ///< false: stopped because the walk was far too long
  bool ended_at_start = false;
  bool stack_empty = false;       ///< nothing but Z_0
  bool map_equals_truth = false;  ///< of the reachable part

  double coverage() const { return static_cast<double>(visited) / static_cast<double>(reachable); }
  /// 2 (C - 1): the fewest moves of a walk through all C reachable cells and back, if they form a tree.
  std::size_t tree_moves() const { return 2 * (reachable - 1); }
  bool complete() const {
    return visited == reachable && halted && ended_at_start && stack_empty && map_equals_truth;
  }
};

struct Exploration {
  ExplorationFigures figures;
  LearnedGrid map;
  std::vector<Side> moves;  ///< all of them with KeepMoves::kYes, else empty
};

enum class KeepMoves { kNo, kYes };

/// A vehicle explores the world from `start` by the rules. It sees only its own cell.
Exploration explore(const GridWorld& world, Cell start, const GridRules& rules, Progress& progress,
                    KeepMoves keep = KeepMoves::kNo);

/// The baseline: always goes to the nearest cell that was seen but not visited, by known paths, and at the
/// end to the start. It has the same sensor and no stack: max_stack is 0.
Exploration explore_nearest_first(const GridWorld& world, Cell start, Progress& progress,
                                  KeepMoves keep = KeepMoves::kNo);

}  // namespace aisle
