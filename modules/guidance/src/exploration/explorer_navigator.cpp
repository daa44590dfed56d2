#include "aisle/guidance/exploration/explorer_navigator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "aisle/vehicle/odometry_step.hpp"

namespace aisle {
namespace {

constexpr double kStopClearance_m = 0.15;  // it stops this far before what came into its path
constexpr double kCoverageEvery_m = 0.5;
constexpr int kAttemptsMax = 4;
constexpr int kHomeAttemptsMax = 4;
constexpr double kFrontierMoved_m = 1;
constexpr int kPocketExpansions = 40000;   // of the path search: a pocket is not worth more
constexpr int kBlocksMax = 3;              // on one spot: then it retreats along its trail
constexpr double kHitNow_m = 1.5;          // within this distance paths keep off the present laser returns
constexpr double kStageLeft_m = 2.5;       // left of a stage when the next one is planned
constexpr double kLearned_m2 = 0.5;        // that much more floor counts as something learned
constexpr double kShown_m2 = 0.03;         // a path that showed this much more floor was worth driving
constexpr double kWedged_m = 0.5;          // a search that gets no farther fails because of where it began
constexpr double kRetreat_m = 3;           // at least, along its trail, before it searches again ...
constexpr double kRoomy_m = 0.15;          // ... where it has this much more clearance than it needs
constexpr int kLastRetreatsMax = 3;        // then it gives up, wherever it is
constexpr int kContactsMax = 5;            // of the bumper: then something is wrong
constexpr double kContactKnown_m = -0.03;  // with less clearance, the floor shows what was touched
constexpr double kIdlePath_m = 150;        // without learning anything: remaining frontiers are left undone;
constexpr double kIdleShare = 0.5;         // at least this share of the path driven while still learning

bool is_same(const ExploringTarget& a, const ExploringTarget& b) {
  if (a.kind != b.kind) return false;
  return a.kind == ExploringTarget::Kind::kHome || a.path == b.path;
}

}  // namespace

void ExplorerNavigatorParams::describe(FieldList& fields) {
  fields.group("learner", learner);
  fields.group("explorer", explorer);
  fields.group("search", search);
  fields.group("steering", steering);
  fields.group("speed", speed);
  fields.real("look_s", look_s, {0, 60}, "time to look around before it starts");
  fields.real("look_from_m", look_from_m, {0.3, 10}, "distance from which it looks at a frontier");
  fields.real("join_m", join_m, {0.1, 5}, "a new path joins the old one this far ahead");
  fields.group("retry_budget", retry_budget);
  fields.real("time_max_s", time_max_s, {10, 100000}, "then it gives up, wherever it is");
  fields.count("expansions", expansions, {10, 100000}, "poses that the path search expands in a cycle");
  fields.real("stuck_s", stuck_s, {1, 3600}, "after standing without a path for this long it gives up");
}

ExplorerNavigator::ExplorerNavigator(const ExplorerNavigatorParams& params, const VehicleDescription& vehicle,
                                     ExploringOrder order, std::unique_ptr<ScanSource> sensor)
    : params_(params),
      vehicle_(vehicle),
      learner_(params.learner, vehicle, std::move(sensor)),
      explorer_(params.explorer, order),
      search_(params.search, vehicle),
      target_search_(search_, learner_,
                     {params.look_from_m, params.explorer.pockets.reach_m, params.explorer.crossing_near_m},
                     vehicle.footprint.front_m),
      driver_(vehicle, params.steering, params.speed),
      retry_budget_(params.retry_budget) {}

Decision ExplorerNavigator::step(const Observation& observation) {
  ++cycle_;
  stamp_s_ = observation.stamp_s;
  if (!begun_s_) begun_s_ = moved_s_ = stamp_s_;
  const FloorLearner::News news = learner_.take(observation);
  driver_.see(learner_.sensor().scanner(), learner_.view().ranges_m);
  mark_coverage();
  if (has_new_contact(observation)) return back_off(observation);
  note_contact();
  if (stamp_s_ - *begun_s_ > params_.time_max_s)
    return end(NavigatorStatus::kFailed, "late", "its time is over");
  if (learner_.is_rebuilding()) return wait_for_floor();
  keep_trail(news);
  if (stamp_s_ - *begun_s_ < params_.look_s || !learner_.has_looked()) return {.state = "looking"};
  if (came_home_) return end(NavigatorStatus::kDone, "home", what_was_explored());
  if (news == FloorLearner::News::kLoop) begin_on_new_floor();
  if (news != FloorLearner::News::kNothing) check_path();
  think(news);
  check_retry_budget();
  if (is_stuck())
    give_up_mission(is_wedged_ ? "finds no path out of where it stands" : "finds no path that it can drive");
  if (!ended_because_.empty()) return end(NavigatorStatus::kFailed, "stuck", ended_because_);
  return drive(observation);
}

std::string ExplorerNavigator::what_was_explored() const {
  const std::size_t undone = explorer_.paths_abandoned();
  const std::string explored = undone == 0
                                   ? "explored"
                                   : fmt::format("came home with {} left undone",
                                                 undone == 1 ? "a path" : fmt::format("{} paths", undone));
  return contacts_ == 0 ? explored : explored + ", but touched something";
}

bool ExplorerNavigator::has_new_contact(const Observation& observation) {
  const bool was_in_contact = std::exchange(is_in_contact_, observation.bumper_pressed);
  return is_in_contact_ && !was_in_contact;
}

/// Stops, and looks for another path, away from what it touched.
Decision ExplorerNavigator::back_off(const Observation& observation) {
  if (++contacts_ > kContactsMax || !learner_.has_looked())
    return end(NavigatorStatus::kFailed, "bumped", "the bumper is pressed");
  is_contact_due_ = driven_gear_.has_value();
  be_blocked(driven_gear_);
  return {.command = {.steering_rad = steering_rad_of(observation.odometry)}, .state = "touched"};
}

/// It touched something right where it stopped; notes that on the floor unless the floor shows it already.
void ExplorerNavigator::note_contact() {
  if (!is_contact_due_ || !learner_.is_standing()) return;
  is_contact_due_ = false;
  const double clearance_m =
      search_.footprint_clearance().standing_clearance_m(learner_.floor(), learner_.T_map_vehicle());
  if (clearance_m > kContactKnown_m) learner_.add_contact(*driven_gear_);
}

void ExplorerNavigator::keep_trail(FloorLearner::News news) {
  if (!learner_.has_looked()) return;
  if (news == FloorLearner::News::kLoop) trail_.lay_again(learner_.T_map_vehicle_of_all());
  if (is_retreating_) return trail_.go_back(learner_.T_map_vehicle());
  trail_.go_on(learner_.T_map_vehicle(), learner_.log().scans.size() - 1);
}

void ExplorerNavigator::mark_coverage() {
  if (!coverage_.empty() && learner_.path_m() - coverage_.back().path_m < kCoverageEvery_m) return;
  coverage_.push_back({learner_.path_m(), learner_.floor().grid().free_m2()});
}

/// Spreads the work over cycles: floor is learned in one, the next looks around for frontiers, the one after
/// chooses a target. All other cycles search for a path.
void ExplorerNavigator::think(FloorLearner::News news) {
  const bool is_news = news != FloorLearner::News::kNothing;
  const bool is_turn_of_look = !std::exchange(is_turn_of_search_, false);
  if (std::exchange(is_choice_due_, false)) {
    choose();
    is_turn_of_search_ = true;
  } else if (is_turn_of_look && (std::exchange(is_look_due_, false) || (!target_ && !is_news))) {
    look_around();
  } else {
    search_path();
  }
  is_look_due_ = is_look_due_ || is_news;
}

/// C99's step 9.
void ExplorerNavigator::look_around() {
  const double middle_m = (vehicle_.footprint.front_m - vehicle_.footprint.rear_m) / 2;
  explorer_.look_around(learner_.floor(), learner_.T_map_vehicle() * Vec2(middle_m, 0));
  is_choice_due_ = true;
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
  is_search_due_ = true;
}

/// Starts at a pose ahead on the present path, so that the vehicle need not stop.
void ExplorerNavigator::begin_search() {
  is_search_due_ = stands_first_ = false;
  p_map_searched_ = target_->frontier.p_map;
  searched_m2_ = learner_.floor().grid().free_m2();
  if (driver_.has_path()) shorten_path(params_.join_m);
  const Path& path = driver_.path();
  const Pose2 T_map_from = path.empty() ? learner_.T_map_vehicle() : path.end();
  target_search_.look_for(*target_, T_map_from, tries_, may_end_at_home(T_map_from));
  const bool is_path = target_->kind == ExploringTarget::Kind::kPath;
  if (target_search_.leads_home() && driver_.has_path()) {
    search_.stop();
    is_search_due_ = stands_first_ = true;
  }
  if (is_path && !target_->frontier.is_pocket && !driver_.has_path())
    target_search_.search_from_ends_too(tries_);
  if (blocks_.was_at(T_map_from)) search_.forbid_first(blocks_.blocked_gear());
  keep_off_what_blocks();
  if (tries_.failures > 0) search_.relax_clearance();
}

/// The present laser returns may lie a little off the floor's occupied cells; and a path through a pose where
/// the vehicle was blocked would be blocked again.
void ExplorerNavigator::keep_off_what_blocks() {
  search_.keep_to([this](const Pose2& T_map_later) {
    if (blocks_.is_barred(T_map_later)) return false;
    const Pose2 T_vehicle_later = between(learner_.T_map_vehicle(), T_map_later);
    return T_vehicle_later.position().norm() > kHitNow_m || driver_.is_off_hit(T_vehicle_later);
  });
}

/// Where no path ends exactly at home, the vehicle first drives near home, and on from there.
bool ExplorerNavigator::may_end_at_home(const Pose2& T_map_from) const {
  return tries_.paths % 2 == 0 && (tries_.paths > 0 || !blocks_.was_at(T_map_from));
}

/// Begins to plan the next stage before the present one ends.
void ExplorerNavigator::search_on() {
  const bool ends_soon = is_stage_ && driver_.has_path() && driver_.left_m() < kStageLeft_m;
  if (!ends_soon || search_.state() != CarSearch::State::kIdle) return;
  is_stage_ = false;
  is_search_due_ = true;
}

void ExplorerNavigator::search_path() {
  if (!target_ || is_retreating_) return;
  search_on();
  if (is_search_due_ && (driver_.has_path() ? !stands_first_ : learner_.is_standing())) begin_search();
  if (search_.state() == CarSearch::State::kIdle && !driver_.has_path() && !is_search_due_) {
    if (cycle_ - arrived_cycle_ <= static_cast<std::size_t>(params_.learner.look_every_cycles)) return;
    const int attempts_max = target_->frontier.is_pocket ? 0 : kAttemptsMax;
    const bool is_over = !is_wedged_ && ++tries_.paths > attempts_max && !was_worth_it();
    if (is_over && target_->kind == ExploringTarget::Kind::kPath) return leave_path();
    begin_search();
  }
  if (search_.state() != CarSearch::State::kSearching) return;
  const auto state = search_.advance(learner_.floor(), params_.expansions);
  const bool is_not_worth_more = target_->frontier.is_pocket && search_.expansions() > kPocketExpansions;
  if (state == CarSearch::State::kFound) return take_path();
  if (state == CarSearch::State::kNone || is_not_worth_more) find_no_path();
}

/// Whether the last path showed new floor.
bool ExplorerNavigator::was_worth_it() const {
  return learner_.floor().grid().free_m2() > searched_m2_ + kShown_m2;
}

/// Either no path leads to the target, or none leads away from where the vehicle stands; that does not count
/// against the target.
void ExplorerNavigator::find_no_path() {
  is_wedged_ = search_.reached_m() < kWedged_m;
  search_.stop();
  arrived_cycle_ = cycle_;
  if (!is_wedged_) count_failure();
  if (blocks_.blocked_gear()) {
    blocks_.unblock_gear();
    if (blocks_.times() > kBlocksMax) retreat();
    return;
  }
  const bool shut_in = is_shut_in();
  if (is_wedged_) tries_.failures = std::max(tries_.failures, 1);
  if ((shut_in && tries_.failures > 0 && retreat()) || is_wedged_) return;
  is_out_of_reach_ = is_out_of_reach_ || is_target_shut_off() || (search_.has_tried_all() && !shut_in);
  const bool is_last_try = target_->frontier.is_pocket ? tries_.failures > 0 : tries_.look_from_afar();
  ++tries_.failures;
  if (!is_last_try || target_->kind != ExploringTarget::Kind::kPath) return;
  leave_path();
}

/// All poses were tried, and none leads even back home: that does not count against the target.
bool ExplorerNavigator::is_shut_in() const {
  return search_.has_tried_all() &&
         !search_.has_come_to(learner_.T_map_home().position(), HomeSearch::kNear_m);
}

/// Even with relaxed clearance, no path leads from where the target can be seen to home or to the vehicle.
bool ExplorerNavigator::is_target_shut_off() const {
  return tries_.failures > 0 &&
         search_.is_shut_off_from(learner_.T_map_home().position(), HomeSearch::kNear_m);
}

/// Drives back as it came, then searches again.
bool ExplorerNavigator::retreat() {
  if (driver_.has_path()) return false;
  const Path back = trail_.path_back(learner_.T_map_vehicle(), kRetreat_m, [this](const Pose2& T_map) {
    return search_.footprint_clearance().clearance_m(learner_.floor(), T_map) > kRoomy_m;
  });
  if (back.empty()) return false;
  driver_.take_trail(back);
  is_retreating_ = is_search_due_ = true;
  return true;
}

/// A failed path home does not count: the vehicle must still come home.
void ExplorerNavigator::count_failure() {
  const bool goes_home = former_ && former_->kind == ExploringTarget::Kind::kHome;
  if (!goes_home) retry_budget_.count_failure(learner_.T_map_vehicle());
}

/// It cannot see past the frontier. A small corner, or a frontier out of reach, is given up; a larger one is
/// abandoned and reported as undone.
void ExplorerNavigator::leave_path() {
  if (is_out_of_reach_ || target_->frontier.behind_m2 < params_.explorer.leftover_m2) return give_path_up();
  explorer_.abandon(target_->path, cycle_);
  drop_path();
  moved_s_ = stamp_s_;
}

/// No pose that the vehicle can reach shows more of the frontier, or hardly anything is left to be seen.
void ExplorerNavigator::give_path_up() {
  explorer_.give_up(target_->path, cycle_);
  drop_path();
  moved_s_ = stamp_s_;
}

/// New floor, or another target, renews the retry budget.
void ExplorerNavigator::note_learning(const ExploringTarget& target) {
  const bool goes_on = former_ && is_same(*former_, target);
  const bool learned = learner_.floor().grid().free_m2() > learned_m2_ + kLearned_m2;
  if (learned) {
    learned_m2_ = learner_.floor().grid().free_m2();
    learned_path_m_ = learner_.path_m();
  }
  if (!learned && goes_on) return;
  const bool is_path = target.kind == ExploringTarget::Kind::kPath;
  const double target_m = is_path ? target.frontier.path_m : learner_.path_m() / 2;
  retry_budget_.renew(stamp_s_, learner_.path_m(), target_m);
  blocks_.unbar();
}

/// Leaves a target undone when its retry budget is over, and all targets when nothing is learned any more.
void ExplorerNavigator::check_retry_budget() {
  if (!target_ || is_wedged_) return;
  const double idle_max_m = std::max(kIdlePath_m, kIdleShare * learned_path_m_);
  const bool is_idle = learner_.path_m() - learned_path_m_ > idle_max_m;
  if (is_idle && target_->kind != ExploringTarget::Kind::kHome) {
    explorer_.abandon_all(cycle_);
    return drop_path();
  }
  if (!retry_budget_.is_over(stamp_s_, learner_.path_m())) return;
  switch (target_->kind) {
    case ExploringTarget::Kind::kPath:
      return leave_path();
    case ExploringTarget::Kind::kCrossing:
      explorer_.pass_crossing_by();
      moved_s_ = stamp_s_;
      return drop_path();
    case ExploringTarget::Kind::kHome:
      return give_up_mission("does not get home");
  }
}

/// The vehicle came along its trail, however narrow that is: it retreats along some of it, then gives up.
void ExplorerNavigator::give_up_mission(const std::string& why) {
  drop_path();
  if (!learner_.is_standing()) return;
  if (++last_retreats_ > kLastRetreatsMax || !retreat()) {
    ended_because_ = why;
    return;
  }
  is_wedged_ = false;
  moved_s_ = stamp_s_;
  retry_budget_.renew(stamp_s_, learner_.path_m(), learner_.path_m() / 2);
}

/// After a loop closure, or with cells halved, the floor is rebuilt while the vehicle stands.
Decision ExplorerNavigator::wait_for_floor() {
  drop_path();
  moved_s_ = stamp_s_;
  return {.state = "laying floor again"};
}

/// The frontiers seen on the former floor are no longer valid.
void ExplorerNavigator::begin_on_new_floor() {
  drop_path();
  is_choice_due_ = false;
}

void ExplorerNavigator::take_path() {
  is_wedged_ = false;
  const Path found = target_search_.path();
  is_stage_ = search_.is_stage();
  ends_at_home_ = target_search_.leads_home();
  search_.stop();
  if (found.empty()) return arrive();
  if (target_->kind == ExploringTarget::Kind::kPath)
    retry_budget_.allow(stamp_s_, learner_.path_m(), found.length_m());
  driver_.take(found);
}

void ExplorerNavigator::arrive() {
  driver_.drop();
  arrived_cycle_ = cycle_;
  is_retreating_ = false;
  if (target_ && target_->kind == ExploringTarget::Kind::kCrossing) return target_.reset();
  if (ends_at_home_) learner_.settle_home();
  const bool is_there = stands_at_home(learner_.T_map_home(), learner_.T_map_vehicle());
  if (!ends_at_home_ || !(is_there || tries_.paths >= kHomeAttemptsMax)) return;
  came_home_ = true;
  explorer_.stop(cycle_);
}

/// Keeps only the next path segment.
void ExplorerNavigator::shorten_path(double ahead_m) {
  driver_.shorten(ahead_m);
  ends_at_home_ = false;
}

void ExplorerNavigator::drop_path() {
  driver_.drop();
  search_.stop();
  target_.reset();
  is_search_due_ = is_retreating_ = false;
  is_stage_ = false;
  ends_at_home_ = false;
}

/// The path may lead through obstacles that were learned since it was planned.
void ExplorerNavigator::check_path() {
  if (!driver_.has_path()) return;
  const double free_m = driver_.free_m(learner_.floor(), learner_.T_map_vehicle());
  if (free_m >= driver_.left_m() - 1e-6) return;
  if (free_m < kStopClearance_m) {
    count_failure();
    return drop_path();
  }
  shorten_path(free_m - kStopClearance_m);
  target_.reset();
}

bool ExplorerNavigator::is_stuck() {
  if (driver_.has_path() && !is_wedged_) moved_s_ = stamp_s_;
  return stamp_s_ - moved_s_ > params_.stuck_s;
}

Decision ExplorerNavigator::drive(const Observation& observation) {
  const std::string state = state_word();
  const PathDriver::Step step =
      driver_.drive(learner_.floor(), search_.footprint_clearance(), learner_.T_map_vehicle(),
                    steering_rad_of(observation.odometry));
  switch (step.state) {
    case PathDriver::State::kNoPath:
      return {.command = step.command, .state = state, .why = why_it_stands()};
    case PathDriver::State::kArrived:
      if (search_.state() != CarSearch::State::kSearching) arrive();
      break;
    case PathDriver::State::kBlocked:
      be_blocked(step.gear);
      return {.command = step.command, .state = "blocked"};
    case PathDriver::State::kTurningWheels:
      break;
    case PathDriver::State::kDriving:
      driven_gear_ = step.gear;
      break;
  }
  return {.command = step.command, .state = state};
}

void ExplorerNavigator::be_blocked(std::optional<Gear> gear) {
  count_failure();
  blocks_.note(learner_.T_map_vehicle(), gear);
  drop_path();
}

std::string ExplorerNavigator::state_word() const {
  if (!driver_.has_path()) return "searching";
  if (is_retreating_) return "retreating";
  if (!target_) return "exploring";
  switch (target_->kind) {
    case ExploringTarget::Kind::kPath:
      return "exploring";
    case ExploringTarget::Kind::kCrossing:
      return "retreating";
    case ExploringTarget::Kind::kHome:
      return "homing";
  }
  return "";
}

std::string ExplorerNavigator::why_it_stands() const {
  if (is_wedged_) return "no path leads out of where it stands";
  return search_.state() == CarSearch::State::kSearching ? "no path found yet" : "";
}

Decision ExplorerNavigator::end(NavigatorStatus status, std::string state, std::string why) {
  ended_because_ = why;
  return {.status = status, .state = std::move(state), .why = std::move(why)};
}

ExplorationRecord ExplorerNavigator::record() const {
  ExplorationRecord record;
  record.paths = explorer_.events();
  record.steps = explorer_.steps();
  record.coverage = coverage_;
  record.T_map_vehicle = learner_.T_map_vehicle_of_all();
  record.paths_waiting = explorer_.paths_waiting();
  record.paths_abandoned = explorer_.paths_abandoned();
  record.path_m = learner_.path_m();
  record.came_home = came_home_;
  record.ended_because = ended_because_;
  return record;
}

}  // namespace aisle
