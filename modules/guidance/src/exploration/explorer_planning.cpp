/// How ExplorerNavigator chooses where to go, and leaves what leads nowhere.

#include "aisle/guidance/exploration/explorer_navigator.hpp"

namespace aisle {
namespace {

constexpr double kStopClearance_m = 0.15;  // it stops this far before what came into its path
constexpr double kFrontierMoved_m = 1;
constexpr int kLastRetreatsMax = 3;  // then it gives up, wherever it is

bool is_same(const ExploringTarget& a, const ExploringTarget& b) {
  if (a.kind != b.kind) return false;
  return a.kind == ExploringTarget::Kind::kHome || a.path == b.path;
}

}  // namespace

void ExplorerNavigator::plan(FloorLearner::News news) {
  const bool is_news = news != FloorLearner::News::kNothing;
  if (news == FloorLearner::News::kLoop) begin_on_new_floor();
  if (is_news) check_path();
  switch (turns_.next(is_news, target_.has_value())) {
    case PlanningTurns::Turn::kLookAround:
      return look_around();
    case PlanningTurns::Turn::kChoose:
      return choose();
    case PlanningTurns::Turn::kSearch:
      return search_path();
  }
}

/// The frontiers seen on the former floor are no longer valid.
void ExplorerNavigator::begin_on_new_floor() {
  drop_path();
  turns_.forget_look();
}

/// The path may lead through obstacles that were learned since it was planned.
void ExplorerNavigator::check_path() {
  if (!driver_.has_path()) return;
  const double free_m = driver_.free_m(learner_.floor(), learner_.T_map_vehicle());
  const double ignored_m = path_end_ == PathEnd::kHome ? HomeSearch::kLast_m : 1e-6;
  if (free_m >= driver_.left_m() - ignored_m) return;
  if (free_m < kStopClearance_m) {
    count_failure();
    return drop_path();
  }
  shorten_path(free_m - kStopClearance_m);
  target_.reset();
}

/// C99's step 9.
void ExplorerNavigator::look_around() {
  const double middle_m = (vehicle_.footprint.front_m - vehicle_.footprint.rear_m) / 2;
  explorer_.look_around(learner_.floor(), learner_.T_map_vehicle() * Vec2(middle_m, 0));
}

/// C99's step 10: the transducer says where to go.
void ExplorerNavigator::choose() {
  const ExploringTarget target =
      explorer_.decide(learner_.floor(), learner_.T_map_vehicle(), learner_.T_map_home(), cycle_);
  if (target.kind == ExploringTarget::Kind::kHome && explorer_.has_left_floor() && learner_.halve_cells()) {
    explorer_.halve_cells();
    return drop_path();
  }
  const bool goes_on = target_ && is_same(*target_, target);
  const bool frontier_moved = (target.frontier.p_map - p_map_searched_).norm() > kFrontierMoved_m;
  if (frontier_moved || !former_ || !is_same(*former_, target)) is_out_of_reach_ = false;
  note_learning(target);
  target_ = former_ = target;
  target_search_.see(target.frontier);
  if (goes_on && (!frontier_moved || target.kind != ExploringTarget::Kind::kPath)) return;
  tries_ = {};
  want_search();
}

/// New floor, or another target, renews the retry budget.
void ExplorerNavigator::note_learning(const ExploringTarget& target) {
  const bool goes_on = former_ && is_same(*former_, target);
  const bool learned = learning_.takes_in(learner_.floor().grid().free_m2(), learner_.path_m());
  if (!learned && goes_on) return;
  const bool is_path = target.kind == ExploringTarget::Kind::kPath;
  const double target_m = is_path ? target.frontier.path_m : learner_.path_m() / 2;
  retry_budget_.renew(timer_.now_s(), learner_.path_m(), target_m);
  blocks_.unbar();
}

/// A target whose retry budget is over, and the mission when the vehicle gets nowhere.
void ExplorerNavigator::leave_what_costs_too_much() {
  if (phase_ == ExploringPhase::kHome) return;
  check_retry_budget();
  if (driver_.has_path() && !is_wedged_) timer_.note_progress();
  if (timer_.is_stuck())
    give_up_mission(is_wedged_ ? "finds no path out of where it stands" : "finds no path that it can drive");
}

/// Leaves a target undone when its retry budget is over, and all targets when nothing is learned any more.
void ExplorerNavigator::check_retry_budget() {
  if (!target_ || is_wedged_) return;
  if (learning_.is_idle(learner_.path_m()) && target_->kind != ExploringTarget::Kind::kHome) {
    explorer_.abandon_all(cycle_);
    return drop_path();
  }
  if (!retry_budget_.is_over(timer_.now_s(), learner_.path_m())) return;
  switch (target_->kind) {
    case ExploringTarget::Kind::kPath:
      return leave_path();
    case ExploringTarget::Kind::kCrossing:
      explorer_.pass_crossing_by();
      timer_.note_progress();
      return drop_path();
    case ExploringTarget::Kind::kHome:
      return give_up_mission("does not get home");
  }
}

/// It cannot see past the frontier. A frontier that no pose within reach shows, or with hardly anything left
/// to be seen behind it, is given up; another one is abandoned and reported as undone, as is each where the
/// vehicle could not even leave the place where it was put.
void ExplorerNavigator::leave_path() {
  const bool is_leftover = target_->frontier.behind_m2 < params_.explorer.leftover_m2;
  if ((is_out_of_reach_ && !is_where_put_) || is_leftover) {
    explorer_.give_up(target_->path, cycle_);
  } else {
    explorer_.abandon(target_->path, cycle_);
  }
  drop_path();
  timer_.note_progress();
}

/// The vehicle came along its trail, however narrow that is: it retreats along some of it, then gives up.
void ExplorerNavigator::give_up_mission(const std::string& why) {
  drop_path();
  if (!learner_.is_standing()) return;
  if (++last_retreats_ > kLastRetreatsMax || !retreat()) {
    end(NavigatorStatus::kFailed, "stuck", why);
    return;
  }
  is_wedged_ = false;
  timer_.note_progress();
  retry_budget_.renew(timer_.now_s(), learner_.path_m(), learner_.path_m() / 2);
}

}  // namespace aisle
