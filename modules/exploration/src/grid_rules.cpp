#include "aisle/exploration/grid_rules.hpp"

#include <algorithm>
#include <bit>
#include <string>

#include "rule_reach.hpp"
#include "scan_sequence.hpp"

namespace aisle {
namespace {

constexpr std::array<std::string_view, 5> kRuleSetNames = {"published", "shortcut", "cells", "homing",
                                                           "roaming"};
constexpr std::array<std::string_view, 9> kInputKindNames = {"one-way",    "crossing",      "ending",
                                                             "explored",   "one-way start", "multi-way start",
                                                             "dead start", "closed",        "detour"};

/// The super rules of C97 section 3.3; 5.3, 6 and 7 are our additions.
enum SuperRule : Symbol { k1, k21, k22, k3, k4, k51, k52, k53, k6, k7 };

constexpr Symbol symbol(GridState state) {
  return static_cast<Symbol>(state);
}
constexpr Symbol output(Side side) {
  return static_cast<Symbol>(side);
}

/// The output that moves to the only side of a set.
Symbol only_side(Sides sides) {
  return static_cast<Symbol>(std::countr_zero(static_cast<unsigned>(sides)));
}

std::vector<Sides> subsets(Sides of, int min_count) {
  std::vector<Sides> found;
  for (unsigned sides = 0; sides <= kEverySide; ++sides) {
    const auto subset = static_cast<Sides>(sides);
    if (without(subset, of) == 0 && std::popcount(sides) >= min_count) found.push_back(subset);
  }
  std::stable_sort(found.begin(), found.end(), [](Sides a, Sides b) {
    return std::popcount(static_cast<unsigned>(a)) < std::popcount(static_cast<unsigned>(b));
  });
  return found;
}

Sides others(Side side) {
  return without(kEverySide, bit(side));
}

class GridRuleMaker {
 public:
  explicit GridRuleMaker(GridRuleSet set) { rules_.set = set; }

  GridRules make() {
    name_alphabets();
    add_inputs();
    fill_table();
    mark_reachable_rules(rules_);
    return std::move(rules_);
  }

 private:
  void name_alphabets();
  void add_inputs();
  Symbol add(GridInput input);

  void fill_table();
  TransducerRule derive(GridState state, const GridInput& input, Symbol top) const;
  TransducerRule cross(const GridInput& input, Symbol top) const;
  TransducerRule pop(const GridInput& input, Symbol top) const;

  GridRules rules_;
};

void GridRuleMaker::name_alphabets() {
  TransducerTable& table = rules_.table;
  table.states = {"q_e", "q_r", "q_fin"};
  table.stack = {"Z_0", "E_l", "E_r", "E_b", "E_t", "R_l", "R_r", "R_b", "R_t"};
  table.outputs = {"O_l", "O_r", "O_b", "O_t", "O_s"};
  table.super_rules = {"1", "2.1", "2.2", "3", "4", "5.1", "5.2", "5.3", "6", "7"};
  table.start_state = symbol(GridState::kExploring);
  table.final_state = symbol(GridState::kFinal);
  table.start_symbol = kStackStart;
}

Symbol GridRuleMaker::add(GridInput input) {
  rules_.inputs.push_back(input);
  rules_.table.inputs.push_back("G" + std::to_string(rules_.inputs.size()));
  return static_cast<Symbol>(rules_.inputs.size() - 1);
}

void GridRuleMaker::add_inputs() {
  const auto at = [](auto& of_side, Side side, Sides sides) -> Symbol& {
    return of_side[static_cast<unsigned>(side)][sides];
  };
  for (const Side came : kAllSides) {
    for (const Side open : kAllSides) {
      if (open != came)
        at(rules_.fresh_input, came, bit(open)) = add({GridInputKind::kOneDirection, came, bit(open)});
    }
  }
  for (const Side came : kAllSides) {
    for (const Sides open : subsets(others(came), 2)) {
      at(rules_.fresh_input, came, open) = add({GridInputKind::kCrossing, came, open});
    }
  }
  for (const Side came : kAllSides)
    at(rules_.fresh_input, came, kNoSides) = add({GridInputKind::kEnding, came});
  for (const Side came : kAllSides)
    at(rules_.explored_input, came, kNoSides) = add({GridInputKind::kExplored, came});
  for (const Side open : kAllSides) {
    rules_.start_input[bit(open)] = add({GridInputKind::kOneDirectionStart, std::nullopt, bit(open)});
  }
  for (const Sides open : subsets(kEverySide, 2)) {
    rules_.start_input[open] = add({GridInputKind::kMultiPathStart, std::nullopt, open});
  }
  rules_.start_input[kNoSides] = add({GridInputKind::kDeadStart});
  if (rules_.set == GridRuleSet::kShortcut || rules_.set == GridRuleSet::kCells) {
    for (const Side came : kAllSides) {
      for (const Sides walls : subsets(others(came), 1)) {
        at(rules_.explored_input, came, walls) = add({GridInputKind::kExplored, came, kNoSides, walls});
      }
    }
  }
  if (rules_.by_shortest_paths()) rules_.closed_input = add({GridInputKind::kClosed});
  if (rules_.set == GridRuleSet::kRoaming) {
    for (const Side open : kAllSides) {
      rules_.detour_input[static_cast<unsigned>(open)] =
          add({GridInputKind::kDetour, std::nullopt, bit(open)});
    }
  }
}

TransducerRule keep(SuperRule super_rule, GridState next, Symbol top, Symbol output) {
  return {symbol(next), output, super_rule, false, 1, {top}};
}

TransducerRule drop(SuperRule super_rule, GridState next, Symbol output) {
  return {symbol(next), output, super_rule, false, 0, {}};
}

/// Super rule 4: the return path is pushed first, then the open sides except the first, which is taken.
TransducerRule GridRuleMaker::cross(const GridInput& input, Symbol top) const {
  TransducerRule rule = keep(k4, GridState::kExploring, top, TransducerRule::kNoOutput);
  if (input.came_from) rule.replacement[rule.length++] = retreat_symbol(*input.came_from);
  for (const Side side : scan_sequence(rules_.set, input.came_from)) {
    if (!contains(input.open, side)) continue;
    if (rule.output == TransducerRule::kNoOutput) {
      rule.output = output(side);
    } else {
      rule.replacement[rule.length++] = explore_symbol(side);
    }
  }
  return rule;
}

/// Super rules 5.2 and 5.3: a path behind a false wall is dropped without a move.
TransducerRule GridRuleMaker::pop(const GridInput& input, Symbol top) const {
  if (top == kStackStart) return keep(k52, GridState::kFinal, top, kStopOutput);
  const Side side = side_of(top);
  if (!is_explore_symbol(top)) return drop(k52, GridState::kRetreating, output(side));
  if (contains(input.false_walls, side)) return drop(k53, GridState::kRetreating, TransducerRule::kNoOutput);
  return drop(k52, GridState::kExploring, output(side));
}

TransducerRule GridRuleMaker::derive(GridState state, const GridInput& input, Symbol top) const {
  const bool exploring = state == GridState::kExploring;
  switch (input.kind) {
    case GridInputKind::kOneDirection:
    case GridInputKind::kOneDirectionStart:
      return keep(k1, state, top, only_side(input.open));
    case GridInputKind::kEnding:
      if (exploring) return keep(k21, GridState::kRetreating, top, output(*input.came_from));
      return top == kStackStart ? keep(k22, GridState::kFinal, top, kStopOutput) : TransducerRule{};
    case GridInputKind::kDeadStart:
      return exploring && top == kStackStart ? keep(k3, GridState::kFinal, top, kStopOutput)
                                             : TransducerRule{};
    case GridInputKind::kCrossing:
    case GridInputKind::kMultiPathStart:
      return exploring ? cross(input, top) : TransducerRule{};
    case GridInputKind::kExplored:
      return exploring ? keep(k51, GridState::kRetreating, top, output(*input.came_from)) : pop(input, top);
    case GridInputKind::kClosed:
      if (exploring) return keep(k6, GridState::kRetreating, top, TransducerRule::kNoOutput);
      return top == kStackStart ? TransducerRule{}
                                : drop(k6, GridState::kRetreating, TransducerRule::kNoOutput);
    case GridInputKind::kDetour:
      return exploring || top == kStackStart ? TransducerRule{}
                                             : keep(k7, GridState::kExploring, top, only_side(input.open));
  }
  return {};
}

void GridRuleMaker::fill_table() {
  TransducerTable& table = rules_.table;
  table.rules.resize(table.transition_rules());
  for (const GridState state : {GridState::kExploring, GridState::kRetreating}) {
    for (std::size_t input = 0; input < table.inputs.size(); ++input) {
      for (Symbol top = 0; top < table.empty_stack(); ++top) {
        const std::size_t place = table.place(symbol(state), static_cast<Symbol>(input), top);
        table.rules[place] = derive(state, rules_.inputs[input], top);
      }
    }
  }
}

}  // namespace

std::string_view name_of(GridRuleSet set) {
  return kRuleSetNames[static_cast<unsigned>(set)];
}

std::optional<GridRuleSet> grid_rule_set(std::string_view name) {
  for (const GridRuleSet set : kGridRuleSets) {
    if (name_of(set) == name) return set;
  }
  return std::nullopt;
}

std::string_view name_of(GridInputKind kind) {
  return kInputKindNames[static_cast<unsigned>(kind)];
}

const GridRules& grid_rules(GridRuleSet set) {
  static const std::array<GridRules, 5> rules = {
      GridRuleMaker(GridRuleSet::kPublished).make(), GridRuleMaker(GridRuleSet::kShortcut).make(),
      GridRuleMaker(GridRuleSet::kCells).make(), GridRuleMaker(GridRuleSet::kHoming).make(),
      GridRuleMaker(GridRuleSet::kRoaming).make()};
  return rules[static_cast<unsigned>(set)];
}

}  // namespace aisle
