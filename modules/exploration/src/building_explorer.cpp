#include "aisle/exploration/building_explorer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

constexpr std::array<std::string_view, 3> kOrderNames = {"published", "recommended", "nearest"};
constexpr double kLeeway_m = 1.5;     // around itself and home the vehicle may lack a disc's clearance
constexpr double kElsewhere_m = 2;    // from where a path was left, before it is retried ...
constexpr double kMoreKnown_m2 = 5;   // ... or this much more floor must be known
constexpr double kDecideAgain_m = 1;  // driven, before the baseline chooses again

Bearing bearing_of(const Vec2& p_map, const Pose2& T_map_vehicle) {
  const double angle_rad = wrap_angle(heading_of(p_map - T_map_vehicle.position()) - T_map_vehicle.theta);
  if (std::abs(angle_rad) < kPi / 4) return Bearing::kForward;
  return angle_rad > 0 ? Bearing::kLeft : Bearing::kRight;
}

/// Distance between two frontiers [cells]; infinity if it is greater than `matters`.
double apart_cells(const Frontier& a, const Frontier& b, double matters) {
  const FloorBox around = a.box.widened(static_cast<int>(std::ceil(matters)));
  double nearest2 = std::numeric_limits<double>::infinity();
  if (around.common_with(b.box).empty()) return nearest2;
  for (const FloorCell p : a.cells) {
    for (const FloorCell q : b.cells) {
      const double dx = p.x - q.x, dy = p.y - q.y;
      nearest2 = std::min(nearest2, dx * dx + dy * dy);
    }
  }
  return std::sqrt(nearest2);
}

}  // namespace

std::string_view name_of(ExploringOrder order) {
  return kOrderNames[static_cast<std::size_t>(order)];
}

std::optional<ExploringOrder> exploring_order(std::string_view name) {
  for (const ExploringOrder order : kExploringOrders) {
    if (name_of(order) == name) return order;
  }
  return std::nullopt;
}

void ExplorerParams::describe(FieldList& fields) {
  fields.group("frontiers", frontiers);
  fields.group("pockets", pockets);
  fields.real("home_weight", home_weight, {0, 1}, "how strongly paths far from home are preferred");
  fields.real("leftover_m2", leftover_m2, {0, 10}, "a frontier with less floor behind it is a leftover");
  fields.real("leftover_bonus_m", leftover_bonus_m, {0, 50},
              "leftovers go before frontiers up to this much nearer");
  fields.real("same_frontier_m", same_frontier_m, {0.05, 2},
              "a frontier within this of an old one continues it");
  fields.real("crossing_near_m", crossing_near_m, {0.1, 5},
              "published order: within this of a crossing the vehicle is back at it");
}

BuildingExplorer::BuildingExplorer(const ExplorerParams& params, ExploringOrder order)
    : params_(params), order_(order), run_(corridor_rules()) {}

void BuildingExplorer::look_around(const KnownFloor& floor, const Vec2& p_map_middle) {
  from_vehicle_.measure(floor, p_map_middle, params_.frontiers.clearance_m, kLeeway_m);
  frontiers_ = find_frontiers(floor, from_vehicle_, params_.frontiers, marks_);
}

ExploringTarget BuildingExplorer::decide(const KnownFloor& floor, const Pose2& T_map_vehicle,
                                         const Pose2& T_map_home, std::size_t cycle) {
  cycle_ = cycle;
  p_map_vehicle_ = T_map_vehicle.position();
  free_m2_ = floor.grid().free_m2();
  if (params_.pockets.path_max_m > 0) {
    std::vector<Frontier> pockets =
        find_pockets(floor, from_vehicle_, frontiers_, params_.frontiers, params_.pockets, marks_);
    std::move(pockets.begin(), pockets.end(), std::back_inserter(frontiers_));
  }
  match_frontiers(floor.grid(), T_map_vehicle);
  if (auto target = go_on(T_map_vehicle)) return *target;
  if (order_ == ExploringOrder::kRecommended)
    from_home_.measure(floor, T_map_home.position(), params_.frontiers.clearance_m, kLeeway_m);
  return take_from_stack(T_map_vehicle);
}

/// Each frontier continues the path that it belonged to, or is a new path that leads off the current one.
/// Paths whose frontier is gone are explored (that also removes the twin at a loop's other end).
void BuildingExplorer::match_frontiers(const FloorGrid& floor, const Pose2& T_map_vehicle) {
  std::vector<std::optional<std::size_t>> continued(frontiers_.size());
  std::vector<std::optional<std::size_t>> frontier_of(paths_.size());
  for (std::size_t i = 0; i < frontiers_.size(); ++i) {
    const auto path = continued_by(floor, frontiers_[i]);
    if (!path) continue;
    std::optional<std::size_t>& best = frontier_of[*path];
    if (best && frontiers_[*best].cells.size() >= frontiers_[i].cells.size()) continue;
    if (best) continued[*best].reset();
    best = i;
    continued[i] = path;
  }
  for (std::size_t p = 0; p < frontier_of.size(); ++p) {
    SeenPath& path = paths_[p];
    if (path.state == PathState::kExplored) continue;
    path.has_frontier = frontier_of[p].has_value();
    if (frontier_of[p]) {
      path.frontier = frontiers_[*frontier_of[p]];
    } else if (!is_left(path)) {
      path.state = PathState::kExplored;
      note(PathEvent::Kind::kExplored, p);
    }
  }
  for (std::size_t i = 0; i < frontiers_.size(); ++i) {
    if (!continued[i]) add_path(frontiers_[i], T_map_vehicle);
  }
}

std::optional<std::size_t> BuildingExplorer::continued_by(const FloorGrid& floor,
                                                          const Frontier& frontier) const {
  const double same_cells = params_.same_frontier_m / floor.cell_m();
  std::optional<std::size_t> nearest;
  double nearest_cells = same_cells;
  for (std::size_t p = 0; p < paths_.size(); ++p) {
    if (paths_[p].state == PathState::kExplored || paths_[p].frontier.is_pocket != frontier.is_pocket)
      continue;
    const double apart = apart_cells(frontier, paths_[p].frontier, same_cells);
    if (apart > nearest_cells) continue;
    nearest_cells = apart;
    nearest = p;
  }
  return nearest;
}

std::size_t BuildingExplorer::add_path(Frontier frontier, const Pose2& T_map_vehicle) {
  const std::size_t path = paths_.size();
  const Bearing bearing = bearing_of(frontier.p_map, T_map_vehicle);
  paths_.push_back({.parent = active_.value_or(path), .bearing = bearing, .frontier = std::move(frontier)});
  return path;
}

/// Exploring: goes on along the active path, or into the best of those that lead off it.
std::optional<ExploringTarget> BuildingExplorer::go_on(const Pose2& T_map_vehicle) {
  if (run_.state() != static_cast<Symbol>(CorridorState::kExploring)) return std::nullopt;
  const bool active_is_open = active_ && paths_[*active_].state == PathState::kActive;
  const bool chooses_again = order_ == ExploringOrder::kNearest &&
                             (T_map_decided_.position() - T_map_vehicle.position()).norm() > kDecideAgain_m;
  if (active_is_open && !chooses_again) {
    push_waiting(T_map_vehicle);
    return ExploringTarget{
        .kind = ExploringTarget::Kind::kPath, .path = *active_, .frontier = paths_[*active_].frontier};
  }
  T_map_decided_ = T_map_vehicle;
  if (active_is_open) {
    paths_[*active_].state = PathState::kWaiting;
  } else if (order_ != ExploringOrder::kNearest) {
    const auto child = best_child();
    if (child && !paths_[*child].on_stack) {
      paths_[*child].state = PathState::kActive;
      push_waiting(T_map_vehicle);
      feed(corridor_input::one_direction(paths_[*child].bearing));
      return take(*child);
    }
  }
  push_waiting(T_map_vehicle);
  feed(corridor_input::kEnd);
  return std::nullopt;
}

/// The nearest of the paths that lead off the one explored last; leftovers go before others.
std::optional<std::size_t> BuildingExplorer::best_child() const {
  std::optional<std::size_t> best;
  double least_m = 1e18;
  for (std::size_t p = 0; p < paths_.size(); ++p) {
    const SeenPath& path = paths_[p];
    if (path.state != PathState::kWaiting || params_.pockets.is_far(path.frontier)) continue;
    const bool from_start = !active_ && path.parent == p;
    if (!from_start && !(active_ && path.parent == *active_)) continue;
    const double path_m =
        path.frontier.path_m - (path.frontier.behind_m2 < params_.leftover_m2 ? params_.leftover_bonus_m : 0);
    if (path_m >= least_m) continue;
    least_m = path_m;
    best = p;
  }
  return best;
}

/// C99's crossing: the return path first, then every path that is left for later.
void BuildingExplorer::push_waiting(const Pose2& T_map_vehicle) {
  bool is_first =
      order_ == ExploringOrder::kPublished && run_.state() == static_cast<Symbol>(CorridorState::kExploring);
  for (std::size_t p = 0; p < paths_.size(); ++p) {
    if (paths_[p].state != PathState::kWaiting || paths_[p].on_stack) continue;
    if (is_first) {
      feed(corridor_input::kCrossingPathBack);
      stack_.push_back({.path = p, .T_map_crossing = T_map_vehicle});
      is_first = false;
    }
    feed(corridor_input::crossing(paths_[p].bearing));
    stack_.push_back({.path = p, .T_map_crossing = T_map_vehicle});
    paths_[p].on_stack = true;
    note(PathEvent::Kind::kPushed, p);
  }
}

/// Retreating: back to the next crossing, into a waiting path, or home.
ExploringTarget BuildingExplorer::take_from_stack(const Pose2& T_map_vehicle) {
  push_waiting(T_map_vehicle);
  close_stale_tops();
  if (T_map_going_back_) {
    const double apart_m = (T_map_going_back_->position() - T_map_vehicle.position()).norm();
    if (apart_m > params_.crossing_near_m && run_.top() == kPathBackSymbol)
      return {.kind = ExploringTarget::Kind::kCrossing,
              .path = 0,
              .frontier = {},
              .T_map_back = *T_map_going_back_};
    pass_crossing_by();
    return take_from_stack(T_map_vehicle);
  }
  if (run_.top() == kPathBackSymbol && order_ == ExploringOrder::kPublished) {
    T_map_going_back_ = stack_.back().T_map_crossing;
    return take_from_stack(T_map_vehicle);
  }
  const auto next = best_waiting();
  if (!next) {
    if (resume_left() || leave_far_pockets()) return take_from_stack(T_map_vehicle);
    if (!is_going_home_) feed(corridor_input::kAway);
    is_going_home_ = true;
    return {};
  }
  is_going_home_ = false;
  const bool is_top = !stack_.empty() && run_.top() != kPathBackSymbol && stack_.back().path == *next;
  if (is_top) {
    feed(corridor_input::kExplored);
    stack_.pop_back();
    paths_[*next].on_stack = false;
  } else {
    feed(corridor_input::detour(paths_[*next].bearing));
  }
  return take(*next);
}

/// Drops symbols on top of the stack whose paths are explored or were taken out of turn.
void BuildingExplorer::close_stale_tops() {
  while (!stack_.empty() && run_.top() != kPathBackSymbol && run_.top() != kCorridorStackStart) {
    SeenPath& path = paths_[stack_.back().path];
    if (path.state == PathState::kWaiting) return;
    feed(corridor_input::kClosed);
    stack_.pop_back();
    path.on_stack = false;
  }
}

std::optional<std::size_t> BuildingExplorer::best_waiting() const {
  if (order_ == ExploringOrder::kPublished) {
    return stack_.empty() ? std::nullopt : std::optional(stack_.back().path);
  }
  const double home_weight = order_ == ExploringOrder::kRecommended ? params_.home_weight : 0;
  std::optional<std::size_t> best;
  double least_m = 1e18;
  for (std::size_t p = 0; p < paths_.size(); ++p) {
    const SeenPath& path = paths_[p];
    if (path.state != PathState::kWaiting || params_.pockets.is_far(path.frontier)) continue;
    double cost_m = path.frontier.path_m;
    if (home_weight > 0) {
      float home_m = FloorDistances::kUnreached;
      if (path.frontier.is_pocket) home_m = from_home_.to(path.frontier.viewpoint);
      for (const FloorCell cell : path.frontier.cells) home_m = std::min(home_m, from_home_.to(cell));
      if (std::isfinite(home_m)) cost_m -= home_weight * home_m;
    }
    if (cost_m >= least_m) continue;
    least_m = cost_m;
    best = p;
  }
  return best;
}

ExploringTarget BuildingExplorer::take(std::size_t path) {
  paths_[path].state = PathState::kActive;
  active_ = path;
  note(PathEvent::Kind::kTaken, path);
  return {.kind = ExploringTarget::Kind::kPath,
          .path = path,
          .frontier = paths_[path].frontier,
          .T_map_back = {}};
}

void BuildingExplorer::pass_crossing_by() {
  if (!T_map_going_back_) return;
  T_map_going_back_.reset();
  if (run_.top() != kPathBackSymbol) return;
  feed(corridor_input::kExplored);
  stack_.pop_back();
}

void BuildingExplorer::give_up(std::size_t path, std::size_t cycle) {
  leave(path, PathState::kGivenUp, PathEvent::Kind::kGivenUp, cycle);
}

void BuildingExplorer::abandon(std::size_t path, std::size_t cycle) {
  leave(path, PathState::kAbandoned, PathEvent::Kind::kAbandoned, cycle);
}

void BuildingExplorer::abandon_all(std::size_t cycle) {
  cycle_ = cycle;
  leave_far_pockets();
  for (std::size_t p = 0; p < paths_.size(); ++p) {
    if (!is_open(paths_[p])) continue;
    abandon(p, cycle);
    paths_[p].chances = 0;
  }
}

void BuildingExplorer::leave(std::size_t path, PathState state, PathEvent::Kind kind, std::size_t cycle) {
  cycle_ = cycle;
  paths_.at(path).state = state;
  paths_[path].p_map_left = p_map_vehicle_;
  paths_[path].free_m2_left = free_m2_;
  note(kind, path);
}

/// With nothing else to do, paths that were left get one more try, from elsewhere or with more known. In a
/// narrow place the position may have been to blame, and early on hardly any floor is known.
bool BuildingExplorer::resume_left() {
  bool resumed = false;
  for (SeenPath& path : paths_) {
    const bool is_elsewhere = (path.p_map_left - p_map_vehicle_).norm() > kElsewhere_m;
    const bool knows_more = free_m2_ > path.free_m2_left + kMoreKnown_m2;
    const bool has_chance =
        path.has_frontier && path.chances > 0 && params_.pockets.is_worth_another_look(path.frontier);
    if (!is_left(path) || !has_chance || !(is_elsewhere || knows_more)) continue;
    --path.chances;
    path.state = PathState::kWaiting;
    resumed = true;
  }
  return resumed;
}

bool BuildingExplorer::has_left_floor() const {
  return std::any_of(paths_.begin(), paths_.end(),
                     [this](const SeenPath& path) { return is_left_with_floor(path); });
}

void BuildingExplorer::halve_cells() {
  for (SeenPath& path : paths_) {
    path.frontier = with_cells_halved(std::move(path.frontier));
    if (is_left_with_floor(path)) path.state = PathState::kWaiting;
  }
}

/// Pockets that the vehicle did not come by are not worth a detour.
bool BuildingExplorer::leave_far_pockets() {
  bool left = false;
  for (std::size_t p = 0; p < paths_.size(); ++p) {
    if (paths_[p].state != PathState::kWaiting || !params_.pockets.is_far(paths_[p].frontier)) continue;
    give_up(p, cycle_);
    left = true;
  }
  return left;
}

/// Paths that were left and have no frontier any more were seen from elsewhere.
void BuildingExplorer::stop(std::size_t cycle) {
  cycle_ = cycle;
  for (std::size_t p = 0; p < paths_.size(); ++p) {
    if (is_left(paths_[p]) && !paths_[p].has_frontier)
      leave(p, PathState::kExplored, PathEvent::Kind::kExplored, cycle);
  }
  feed(corridor_input::kExplored);
}

std::size_t BuildingExplorer::paths_waiting() const {
  return static_cast<std::size_t>(std::count_if(paths_.begin(), paths_.end(), is_open));
}

std::size_t BuildingExplorer::paths_abandoned() const {
  return static_cast<std::size_t>(std::count_if(paths_.begin(), paths_.end(), [](const SeenPath& path) {
    return path.state == PathState::kAbandoned && path.has_frontier;
  }));
}

const TransducerRule& BuildingExplorer::feed(Symbol input) {
  const TransducerRule& rule = run_.step(input);
  const TransducerTable& table = corridor_rules();
  steps_.push_back({.cycle = cycle_,
                    .state = table.states[run_.state()],
                    .input = table.inputs[input],
                    .output = rule.output == TransducerRule::kNoOutput ? "" : table.outputs[rule.output],
                    .stack = run_.stack().size() - 1});
  return rule;
}

void BuildingExplorer::note(PathEvent::Kind kind, std::size_t path) {
  events_.push_back({.cycle = cycle_,
                     .kind = kind,
                     .path = path,
                     .parent = paths_[path].parent,
                     .symbol = corridor_rules().stack[explore_symbol(paths_[path].bearing)],
                     .p_map = paths_[path].frontier.p_map});
}

}  // namespace aisle
