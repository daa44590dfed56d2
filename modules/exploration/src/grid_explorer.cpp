#include "aisle/exploration/grid_explorer.hpp"

#include <algorithm>
#include <utility>

namespace aisle {
namespace {

/// Beyond this many cells a shorter way is no longer looked for; the way back over the parents is taken.
constexpr std::size_t kSearchedCells = 1 << 16;

constexpr bool is_several(Sides sides) {
  return (sides & (sides - 1)) != 0;
}

constexpr std::size_t place(Side side) {
  return static_cast<std::size_t>(side);
}

}  // namespace

GridExplorer::GridExplorer(const GridRules& rules, int width, int height, Cell start, Watcher watcher)
    : rules_(&rules),
      watcher_(std::move(watcher)),
      run_(rules.table),
      map_(width, height),
      notes_(map_.size(), 0),
      start_(map_.index(start)),
      at_(start_) {}

std::optional<Side> GridExplorer::step(Sides open) {
  if (!map_.visited(at_)) learn(open);
  while (true) {
    last_input_ = encode(open);
    last_rule_ = &run_.step(last_input_);
    if (watcher_) watcher_(*last_rule_);
    if (rules_->set == GridRuleSet::kHoming) {
      places_.resize(run_.stack().size() - 1, static_cast<std::uint32_t>(at_));
    }
    if (last_rule_->output == kStopOutput) return std::nullopt;
    if (last_rule_->output != TransducerRule::kNoOutput) break;
  }
  const Side side = static_cast<Side>(last_rule_->output);
  at_ = map_.neighbour(at_, side);
  came_from_ = opposite(side);
  return side;
}

void GridExplorer::learn(Sides open) {
  map_.see(at_, open);
  if (came_from_) notes_[at_] = static_cast<std::uint8_t>(place(*came_from_) << 2);
  if (rules_->set == GridRuleSet::kCells || rules_->set == GridRuleSet::kHoming) close_ways_to_visited(open);
}

/// A new cell shows that an edge leads to a visited one: nothing is left to find behind it, from either end.
void GridExplorer::close_ways_to_visited(Sides open) {
  for (const Side side : kAllSides) {
    if (!contains(open, side) || side == came_from_) continue;
    const std::size_t beyond = map_.neighbour(at_, side);
    if (!map_.visited(beyond)) continue;
    put_false_wall(at_, side);
    put_false_wall(beyond, opposite(side));
  }
}

void GridExplorer::put_false_wall(std::size_t cell, Side side) {
  notes_[cell] = static_cast<std::uint8_t>(notes_[cell] | bit(side) << 4);
}

/// The preprocessing unit (C97 section 3.3).
Symbol GridExplorer::encode(Sides open) {
  if (!came_from_) return encode_start(open);
  if (rules_->set == GridRuleSet::kHoming) return encode_homing(open);
  if (is_explored_crossing(at_)) return encode_explored(*came_from_);
  return encode_fresh(open);
}

/// The paper leaves it open, but without it the vehicle would not stop there: a start with several ways is an
/// explored crossing from then on.
Symbol GridExplorer::encode_start(Sides open) {
  if (is_several(open)) notes_[at_] |= kCrossing;
  return rules_->start_input[open];
}

Symbol GridExplorer::encode_fresh(Sides open) {
  const Sides ahead = without(open, false_walls(at_) | bit(*came_from_));
  if (is_several(ahead)) notes_[at_] |= kCrossing;
  return rules_->fresh_input[place(*came_from_)][ahead];
}

Symbol GridExplorer::encode_explored(Side came) {
  const bool found_from_other_end = run_.state() == static_cast<Symbol>(GridState::kExploring);
  if (rules_->set == GridRuleSet::kShortcut && found_from_other_end) put_false_wall(at_, came);
  return rules_->explored_input[place(came)][without(false_walls(at_), bit(came))];
}

/// While retreating, false walls leave nothing open but the shortest known way to where the stack's top was
/// pushed.
Symbol GridExplorer::encode_homing(Sides open) {
  if (run_.state() == static_cast<Symbol>(GridState::kExploring)) {
    const bool dead_end = without(open, false_walls(at_) | bit(*came_from_)) == kNoSides;
    return dead_end ? rules_->closed_input : encode_fresh(open);
  }
  if (top_is_stale()) return rules_->closed_input;
  const std::size_t goal = places_.empty() ? start_ : places_.back();
  if (at_ == goal) {
    return is_explored_crossing(at_) ? rules_->explored_input[place(*came_from_)][kNoSides]
                                     : encode_fresh(open);
  }
  if (way_.empty()) find_way(goal);
  const Side next = way_.back();
  way_.pop_back();
  const Side false_wall = *came_from_ == next ? opposite(next) : *came_from_;
  return rules_->fresh_input[place(false_wall)][bit(next)];
}

/// Whether the path on top of the stack leads to nothing new.
bool GridExplorer::top_is_stale() const {
  const Symbol top = run_.top();
  if (top == kStackStart) return false;
  return !is_explore_symbol(top) || contains(false_walls(places_.back()), side_of(top));
}

void GridExplorer::find_way(std::size_t goal) {
  const auto is_goal = [goal](std::size_t cell) { return cell == goal; };
  if (ways_.search(map_, at_, is_goal, kSearchedCells)) {
    ways_.take_way(map_, goal, way_);
    return;
  }
  for (std::size_t cell = at_; cell != goal; cell = map_.neighbour(cell, way_.back()))
    way_.push_back(parent(cell));
  std::reverse(way_.begin(), way_.end());
}

}  // namespace aisle
