#pragma once
/// The rules by which a vehicle explores a world of cells: C97's navigation transducer, and what follows from
/// the same super rules with more false walls. docs/explanation/mazes.md explains them with pictures.

#include <optional>
#include <string_view>
#include <vector>

#include "aisle/exploration/grid_world.hpp"
#include "aisle/exploration/pushdown_transducer.hpp"

namespace aisle {

enum class GridRuleSet {
  kPublished,  ///< C97 as it stands
  kShortcut,   ///< a path already walked from its other end is not walked again: no edge more than twice
  kCells,      ///< no path to a visited cell is walked: 2 (C - 1) moves for C reachable cells
  kHoming,     ///< as kCells, but retreats by the shortest known path: at most 2 (C - 1) moves
  kRoaming,    ///< as kHoming, but paths that are near, or far from home, go before the stack's top
};

inline constexpr GridRuleSet kGridRuleSets[] = {GridRuleSet::kPublished, GridRuleSet::kShortcut,
                                                GridRuleSet::kCells, GridRuleSet::kHoming,
                                                GridRuleSet::kRoaming};

std::string_view name_of(GridRuleSet set);
std::optional<GridRuleSet> grid_rule_set(std::string_view name);

/// The states, in the order of C97's Table 2.
enum class GridState : Symbol { kExploring, kRetreating, kFinal };

/// Outputs are the sides in the order of Side, then "stop" (C97 Table 1).
inline constexpr Symbol kStopOutput = 4;

/// Stack symbols (C97 Table 3): the start symbol, then a path to explore on each side, then a path to retreat
/// by.
inline constexpr Symbol kStackStart = 0;
constexpr Symbol explore_symbol(Side side) {
  return static_cast<Symbol>(1 + static_cast<unsigned>(side));
}
constexpr Symbol retreat_symbol(Side side) {
  return static_cast<Symbol>(5 + static_cast<unsigned>(side));
}
constexpr bool is_explore_symbol(Symbol symbol) {
  return symbol >= 1 && symbol <= 4;
}
/// Not for the start symbol.
constexpr Side side_of(Symbol stack_symbol) {
  return static_cast<Side>((stack_symbol - 1) % 4);
}

/// What an input symbol stands for (C97 Figure 3).
enum class GridInputKind : std::uint8_t {
  kOneDirection,       ///< G1 - G12
  kCrossing,           ///< G13 - G28
  kEnding,             ///< G29 - G32
  kExplored,           ///< G33 - G36; with false walls on further sides: beyond the paper
  kOneDirectionStart,  ///< G37 - G40
  kMultiPathStart,     ///< G41 - G51
  kDeadStart,          ///< G52
  kClosed,             ///< beyond the paper: the path on top of the stack leads to nothing new
  kDetour,             ///< beyond the paper: a path below the top of the stack is taken first
};

struct GridInput {
  GridInputKind kind = GridInputKind::kDeadStart;
  std::optional<Side> came_from;  ///< a false wall is put there; none at the start
  Sides open = kNoSides;          ///< as the preprocessing unit presents it; not set for explored cells
  Sides false_walls = kNoSides;   ///< of explored cells: further sides that need not be visited
};

std::string_view name_of(GridInputKind kind);

/// One rule set: its transducer, and which input symbol stands for what is sensed.
struct GridRules {
  GridRuleSet set = GridRuleSet::kPublished;
  TransducerTable table;
  std::vector<GridInput> inputs;                           ///< in the order of table.inputs: G1, G2, ...
  std::array<Symbol, 16> start_input{};                    ///< [open sides]
  std::array<std::array<Symbol, 16>, 4> fresh_input{};     ///< [side come from][other open sides]
  std::array<std::array<Symbol, 16>, 4> explored_input{};  ///< [side come from][false walls on other sides]
  Symbol closed_input = 0;
  std::array<Symbol, 4> detour_input{};  ///< [side to take]

  bool by_shortest_paths() const { return set == GridRuleSet::kHoming || set == GridRuleSet::kRoaming; }
};

/// Built once, then shared.
const GridRules& grid_rules(GridRuleSet set);

}  // namespace aisle
