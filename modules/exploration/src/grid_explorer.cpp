#include "aisle/exploration/grid_explorer.hpp"

#include <algorithm>
#include <utility>

namespace aisle {
namespace {

/// The search for a shorter path ends after this many cells; the return path along the parents is taken then.
constexpr std::size_t kSearchedCells = 1 << 16;

constexpr std::size_t kCellsSearchedForDetour = 256;

/// Weights of a move and of a cell's distance from home in the choice of the next path to explore.
constexpr std::int64_t kPathWeight = 10;
constexpr std::int64_t kHomeWeight = 5;

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
      at_(start_) {
  if (rules.set == GridRuleSet::kRoaming) home_.emplace(map_.size(), start_);
}

std::optional<Side> GridExplorer::step(Sides open) {
  if (!map_.visited(at_)) learn(open);
  while (true) {
    last_input_ = encode(open);
    last_rule_ = &run_.step(last_input_);
    if (watcher_) watcher_(*last_rule_);
    if (rules_->by_shortest_paths()) places_.resize(run_.stack().size() - 1, static_cast<std::uint32_t>(at_));
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
  if (rules_->set == GridRuleSet::kCells || rules_->by_shortest_paths()) close_paths_to_visited(open);
  if (home_) home_->add(map_, at_);
}

/// A new cell shows that an edge leads to a visited cell: it hides nothing new from either end.
void GridExplorer::close_paths_to_visited(Sides open) {
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
  if (rules_->by_shortest_paths()) return encode_homing(open);
  if (is_explored_crossing(at_)) return encode_explored(*came_from_);
  return encode_fresh(open);
}

/// The paper leaves this open, but without it the vehicle would not stop there: a start with several paths is
/// an explored crossing from then on.
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

/// While retreating, false walls leave nothing open but the shortest known path to where the stack's top was
/// pushed.
Symbol GridExplorer::encode_homing(Sides open) {
  if (run_.state() == static_cast<Symbol>(GridState::kExploring)) {
    const bool dead_end = without(open, false_walls(at_) | bit(*came_from_)) == kNoSides;
    return dead_end ? rules_->closed_input : encode_fresh(open);
  }
  if (top_is_stale()) return rules_->closed_input;
  const std::size_t goal = places_.empty() ? start_ : places_.back();
  if (path_.empty() && !detour_ && at_ != goal) find_path(goal);
  if (!path_.empty()) {
    const Side next = path_.back();
    path_.pop_back();
    return encode_move(next);
  }
  if (detour_) {
    const Side side = std::exchange(detour_, std::nullopt)->side;
    put_false_wall(at_, side);
    return rules_->detour_input[place(side)];
  }
  return is_explored_crossing(at_) ? rules_->explored_input[place(*came_from_)][kNoSides]
                                   : encode_fresh(open);
}

/// A cell with no side open but `next`.
Symbol GridExplorer::encode_move(Side next) {
  const Side false_wall = *came_from_ == next ? opposite(next) : *came_from_;
  return rules_->fresh_input[place(false_wall)][bit(next)];
}

/// Whether the path on top of the stack leads to nothing new.
bool GridExplorer::top_is_stale() const {
  const Symbol top = run_.top();
  if (top == kStackStart) return false;
  return !is_explore_symbol(top) || contains(false_walls(places_.back()), side_of(top));
}

void GridExplorer::find_path(std::size_t goal) {
  const auto is_goal = [goal](std::size_t cell) { return cell == goal; };
  const bool roaming = rules_->set == GridRuleSet::kRoaming;
  if (paths_.search(map_, at_, is_goal, roaming ? SIZE_MAX : kSearchedCells)) {
    paths_.take_path(map_, goal, path_);
    if (roaming) look_for_detour(goal);
    return;
  }
  for (std::size_t cell = at_; cell != goal; cell = map_.neighbour(cell, path_.back()))
    path_.push_back(parent(cell));
  std::reverse(path_.begin(), path_.end());
}

/// Replaces the path to `goal` by one to a path that is nearer, or farther from home. A move adds at most one
/// to the distance from home, so beyond some distance nothing better can come.
void GridExplorer::look_for_detour(std::size_t goal) {
  if (places_.empty()) return;
  const auto score = [](std::size_t moves, std::size_t home) {
    return kPathWeight * static_cast<std::int64_t>(moves) - kHomeWeight * static_cast<std::int64_t>(home);
  };
  std::int64_t best = score(path_.size(), (*home_)[goal]);
  const std::size_t home_from_here = (*home_)[at_];
  const auto is_beyond_all = [&](std::size_t cell) {
    const std::size_t moves = paths_.distance(cell);
    if (score(moves, home_from_here + moves) >= best) return true;
    if (!is_explored_crossing(cell) || score(moves, (*home_)[cell]) >= best) return false;
    if (const auto side = unexplored_side(cell)) {
      best = score(moves, (*home_)[cell]);
      detour_ = Detour{cell, *side};
    }
    return false;
  };
  (void)paths_.search(map_, at_, is_beyond_all, kCellsSearchedForDetour);
  if (detour_) paths_.take_path(map_, detour_->cell, path_);
}

std::optional<Side> GridExplorer::unexplored_side(std::size_t cell) const {
  for (const Side side : kAllSides) {
    const bool leads_on = contains(without(map_.open(cell), false_walls(cell)), side);
    if (leads_on && !map_.visited(map_.neighbour(cell, side))) return side;
  }
  return std::nullopt;
}

}  // namespace aisle
