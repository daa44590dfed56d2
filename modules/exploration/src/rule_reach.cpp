#include "rule_reach.hpp"

#include <algorithm>
#include <bit>
#include <vector>

#include "scan_sequence.hpp"

namespace aisle {
namespace {

/// Every way in which the vehicle may come back to a registered crossing: the sides are left one after the
/// other, and meanwhile further sides may turn out to be known from their other ends.
class CrossingLives {
 public:
  explicit CrossingLives(GridRules& rules) : rules_(rules) {}

  void live(const GridInput& crossing) {
    came_from_ = crossing.came_from;
    std::vector<Side> waiting;
    for (const Side side : scan_sequence(rules_.set, came_from_)) {
      if (contains(crossing.open, side)) waiting.push_back(side);
    }
    const Side first = waiting.front();
    waiting.erase(waiting.begin());
    for_each_subset(known_on_arrival(crossing), [&](Sides walls) {
      may_find_walls_ = has_false_walls() && !(came_from_ && contains(walls, opposite(*came_from_)));
      leave(first, waiting, walls);
    });
  }

 private:
  bool has_false_walls() const {
    return rules_.set == GridRuleSet::kShortcut || rules_.set == GridRuleSet::kCells;
  }

  /// Sides that lead to cells visited before. A cell's first side is walked as soon as it is seen, so no such
  /// cell has this one as its first.
  Sides known_on_arrival(const GridInput& crossing) const {
    if (rules_.set != GridRuleSet::kCells || !came_from_) return kNoSides;
    const Side never = opposite(scan_sequence(rules_.set, std::nullopt).front());
    return without(kEverySide, crossing.open | bit(*came_from_) | bit(never));
  }

  template <class Visit>
  static void for_each_subset(Sides of, Visit visit) {
    for (unsigned sides = 0; sides <= kEverySide; ++sides) {
      if (without(static_cast<Sides>(sides), of) == 0) visit(static_cast<Sides>(sides));
    }
  }

  void leave(Side out, const std::vector<Side>& waiting, Sides walls) {
    Sides may_become_known = kNoSides;
    for (const Side side : waiting) may_become_known |= bit(side);
    if (!may_find_walls_) may_become_known = kNoSides;
    for_each_subset(without(may_become_known, walls), [&](Sides found) {
      const auto known = static_cast<Sides>(walls | found);
      if (rules_.set == GridRuleSet::kShortcut) be_found(without(may_become_known, known), known);
      come_back(out, waiting, known);
    });
  }

  /// The vehicle, exploring, arrives by one of `sides`.
  void be_found(Sides sides, Sides walls) {
    for (const Side side : kAllSides) {
      if (!contains(sides, side)) continue;
      for (Symbol top = 1; top < rules_.table.empty_stack(); ++top)
        mark(GridState::kExploring, side, walls, top);
    }
  }

  void come_back(Side from, std::vector<Side> waiting, Sides walls) {
    while (!waiting.empty()) {
      const Side next = waiting.back();
      waiting.pop_back();
      mark(GridState::kRetreating, from, walls, explore_symbol(next));
      if (!contains(walls, next)) return leave(next, waiting, walls);
    }
    mark(GridState::kRetreating, from, walls, came_from_ ? retreat_symbol(*came_from_) : kStackStart);
  }

  void mark(GridState state, Side came, Sides walls, Symbol top) {
    const Symbol input = rules_.explored_input[static_cast<unsigned>(came)][without(walls, bit(came))];
    rules_.table.rules[rules_.table.place(static_cast<Symbol>(state), input, top)].reachable = true;
  }

  GridRules& rules_;
  std::optional<Side> came_from_;
  /// False if the side opposite the entry is known: the path walked so far is then a closed curve through the
  /// crossing, and the other two sides lie on different sides of it.
  bool may_find_walls_ = false;
};

class ReachMarker {
 public:
  explicit ReachMarker(GridRules& rules) : rules_(rules) {}

  void mark() {
    find_what_is_pushed();
    for (const GridInput& input : rules_.inputs) {
      const bool crossing =
          input.kind == GridInputKind::kCrossing || input.kind == GridInputKind::kMultiPathStart;
      if (crossing && !rules_.by_shortest_paths()) CrossingLives(rules_).live(input);
    }
    TransducerTable& table = rules_.table;
    for (const GridState state : {GridState::kExploring, GridState::kRetreating}) {
      for (std::size_t input = 0; input < table.inputs.size(); ++input) {
        for (Symbol top = 0; top < table.empty_stack(); ++top) {
          TransducerRule& rule =
              table.rules[table.place(static_cast<Symbol>(state), static_cast<Symbol>(input), top)];
          rule.reachable = rule.defined() && on_stack_[top] &&
                           (rule.reachable || is_reachable(state, rules_.inputs[input], top));
        }
      }
    }
  }

 private:
  void find_what_is_pushed() {
    on_stack_[kStackStart] = true;
    for (const TransducerRule& rule : rules_.table.rules) {
      for (Symbol i = 1; i < rule.length; ++i) on_stack_[rule.replacement[i]] = true;
    }
  }

  /// For what CrossingLives leaves open.
  bool is_reachable(GridState state, const GridInput& input, Symbol top) const {
    const bool exploring = state == GridState::kExploring;
    switch (input.kind) {
      case GridInputKind::kOneDirection:
        return exploring || !rules_.by_shortest_paths() || top == kStackStart || is_explore_symbol(top);
      case GridInputKind::kEnding:
        return !rules_.by_shortest_paths() || !exploring;
      case GridInputKind::kExplored:
        return exploring ? is_found_again(input, top)
                         : rules_.by_shortest_paths() && awaits(*input.came_from, top);
      case GridInputKind::kCrossing:
      case GridInputKind::kClosed:
        return true;
      case GridInputKind::kDetour:
        return is_explore_symbol(top);
      case GridInputKind::kOneDirectionStart:
      case GridInputKind::kMultiPathStart:
      case GridInputKind::kDeadStart:
        return exploring && top == kStackStart;
    }
    return false;
  }

  /// A crossing's first side is walked before any other, so it is found from its other end only after a path
  /// was popped there; and the last side of the scan is popped first.
  bool is_found_again(const GridInput& input, Symbol top) const {
    if (rules_.set != GridRuleSet::kPublished) return false;
    const auto scan = scan_sequence(rules_.set, std::nullopt);
    return input.came_from != scan.front() || top != explore_symbol(scan.back());
  }

  static bool awaits(Side came, Symbol top) {
    return top == kStackStart || (is_explore_symbol(top) && side_of(top) != came);
  }

  GridRules& rules_;
  std::array<bool, 9> on_stack_{};
};

}  // namespace

void mark_reachable_rules(GridRules& rules) {
  ReachMarker(rules).mark();
}

}  // namespace aisle
