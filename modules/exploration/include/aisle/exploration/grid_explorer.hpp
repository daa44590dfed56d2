#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "aisle/exploration/grid_rules.hpp"
#include "aisle/exploration/home_distances.hpp"
#include "aisle/exploration/known_paths.hpp"

namespace aisle {

/// Explores an unknown world of cells: preprocessing unit, navigation transducer and map building in one (C97
/// section 2.2, Algorithm 1). It sees one cell at a time and moves nothing itself.
class GridExplorer {
 public:
  using Watcher = std::function<void(const TransducerRule&)>;

  /// @param width, height  of the map; the rules make no use of them
  /// @param watcher  called with every rule that fires, also those without a move; may be empty
  GridExplorer(const GridRules& rules, int width, int height, Cell start, Watcher watcher = {});

  /// One learning cycle: takes the open sides of the vehicle's cell and returns the side to move to.
  /// @return nullopt to stop, when everything reachable is explored; do not call again after that
  std::optional<Side> step(Sides open);

  Cell at() const { return map_.cell(at_); }
  std::size_t at_index() const { return at_; }
  const GridRules& rules() const { return *rules_; }
  const TransducerRun& transducer() const { return run_; }

  /// The learned map. Sides of cells that were not visited are closed.
  const LearnedGrid& map() const { return map_; }
  /// Whether the cell is in the list of explored crossings.
  bool is_explored_crossing(std::size_t cell) const { return (notes_[cell] & kCrossing) != 0; }

  /// The input and the rule of the latest cycle.
  Symbol last_input() const { return last_input_; }
  const TransducerRule& last_rule() const { return *last_rule_; }

 private:
  enum Note : std::uint8_t { kCrossing = 1 };  ///< bits 2 and 3: the parent's side, bits 4 to 7: false walls

  Sides false_walls(std::size_t cell) const { return notes_[cell] >> 4; }
  void put_false_wall(std::size_t cell, Side side);
  Side parent(std::size_t cell) const { return static_cast<Side>(notes_[cell] >> 2 & 3); }

  void learn(Sides open);
  void close_paths_to_visited(Sides open);
  Symbol encode(Sides open);
  Symbol encode_start(Sides open);
  Symbol encode_fresh(Sides open);
  Symbol encode_explored(Side came);
  Symbol encode_homing(Sides open);
  bool top_is_stale() const;
  Symbol encode_move(Side next);
  void find_path(std::size_t goal);
  void look_for_detour(std::size_t goal);
  std::optional<Side> unexplored_side(std::size_t cell) const;

  const GridRules* rules_;
  Watcher watcher_;
  TransducerRun run_;
  LearnedGrid map_;
  std::vector<std::uint8_t> notes_;
  std::size_t start_;
  std::size_t at_;
  std::optional<Side> came_from_;
  Symbol last_input_ = 0;
  const TransducerRule* last_rule_ = nullptr;

  // kHoming and kRoaming: where each symbol of the stack was pushed; the rest of the current path, its next
  // move last.
  std::vector<std::uint32_t> places_;
  KnownPaths paths_;
  std::vector<Side> path_;

  /// kRoaming: the cell at which to leave the stack's order, and the side to take there.
  struct Detour {
    std::size_t cell;
    Side side;
  };
  std::optional<Detour> detour_;
  std::optional<HomeDistances> home_;
};

}  // namespace aisle
