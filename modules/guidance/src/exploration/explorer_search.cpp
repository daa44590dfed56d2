/// How ExplorerNavigator gets to its target.

#include <algorithm>
#include <utility>

#include "aisle/guidance/exploration/explorer_navigator.hpp"

namespace aisle {
namespace {

constexpr int kAttemptsMax = 4;
constexpr int kPocketExpansions = 40000;  // of the path search: a pocket is not worth more
constexpr int kBlocksMax = 3;             // on one spot: then it retreats along its trail
constexpr double kHitNow_m = 1.5;         // within this distance paths keep off the present laser returns
constexpr double kStageLeft_m = 2.5;      // left of a stage when the next one is planned
constexpr double kShown_m2 = 0.03;        // a path that showed this much more floor was worth driving
constexpr double kWedged_m = 0.5;         // a search that gets no farther fails because of where it began
constexpr double kRetreat_m = 3;          // at least, along its trail, before it searches again ...
constexpr double kRoomy_m = 0.15;         // ... where it has this much more clearance than it needs
constexpr double kTrailIn_m = 1;  // it goes into its first pose as it left it at least from this far away
constexpr double kProbe_m = 0.3;  // of path over unknown floor, before it searches again

}  // namespace

void ExplorerNavigator::search_path() {
  if (!target_ || phase_ == ExploringPhase::kRetreating || phase_ == ExploringPhase::kProbing) return;
  search_on();
  if (is_time_to_search()) begin_search();
  const bool has_none = !driver_.has_path() && search_due_ == SearchDue::kNo;
  if (has_none && search_.state() == CarSearch::State::kIdle) search_again();
  if (search_.state() == CarSearch::State::kSearching) advance_search();
}

/// The last path did not settle the target, or none was found. A new scan has to be on the floor first.
void ExplorerNavigator::search_again() {
  if (cycle_ - arrived_cycle_ <= static_cast<std::size_t>(params_.learner.look_every_cycles)) return;
  const int attempts_max = target_->frontier.is_pocket ? 0 : kAttemptsMax;
  const bool is_over = !is_wedged_ && ++tries_.paths > attempts_max && !was_worth_it();
  if (is_over && target_->kind == ExploringTarget::Kind::kPath) return leave_path();
  begin_search();
}

void ExplorerNavigator::advance_search() {
  const auto state = search_.advance(learner_.floor(), params_.expansions);
  const bool is_not_worth_more = target_->frontier.is_pocket && search_.expansions() > kPocketExpansions;
  if (state == CarSearch::State::kFound) return take_path();
  if (state == CarSearch::State::kNone || is_not_worth_more) find_no_path();
}

/// Begins to plan the next stage before the present one ends.
void ExplorerNavigator::search_on() {
  const bool ends_soon =
      path_end_ == PathEnd::kStage && driver_.has_path() && driver_.left_m() < kStageLeft_m;
  if (!ends_soon || search_.state() != CarSearch::State::kIdle) return;
  path_end_ = PathEnd::kElsewhere;
  want_search();
}

void ExplorerNavigator::want_search() {
  if (search_due_ == SearchDue::kNo) search_due_ = SearchDue::kNow;
}

bool ExplorerNavigator::is_time_to_search() const {
  if (driver_.has_path()) return search_due_ == SearchDue::kNow;
  return search_due_ != SearchDue::kNo && learner_.is_standing();
}

/// Starts at a pose ahead on the present path, so that the vehicle need not stop.
void ExplorerNavigator::begin_search() {
  search_due_ = SearchDue::kNo;
  p_map_searched_ = target_->frontier.p_map;
  searched_m2_ = learner_.floor().grid().free_m2();
  if (driver_.has_path()) shorten_path(params_.join_m);
  const Path& path = driver_.path();
  const Pose2 T_map_from = path.empty() ? learner_.T_map_vehicle() : path.end();
  target_search_.look_for(*target_, T_map_from, tries_, may_end_at_home(T_map_from), trail_in());
  const bool is_path = target_->kind == ExploringTarget::Kind::kPath;
  if (target_search_.leads_home() && driver_.has_path()) {
    search_.stop();
    search_due_ = SearchDue::kOnceItStands;
  }
  if (is_path && !target_->frontier.is_pocket && !driver_.has_path())
    target_search_.search_from_ends_too(tries_);
  if (blocks_.was_at(T_map_from)) search_.forbid_first(blocks_.blocked_direction());
  keep_off_what_blocks();
  if (tries_.failures > 0) search_.relax_clearance();
  if (tries_.probe) search_.cross_unknown();
}

/// Where no path ends exactly at home, the vehicle first drives near home, and on from there.
bool ExplorerNavigator::may_end_at_home(const Pose2& T_map_from) const {
  return tries_.paths % 2 == 0 && (tries_.paths > 0 || !blocks_.was_at(T_map_from));
}

/// Into its first pose, as it left it.
Path ExplorerNavigator::trail_in() const {
  if (target_->kind != ExploringTarget::Kind::kHome) return {};
  return trail_.path_to_begin(learner_.T_map_home(), learner_.T_map_vehicle(), kTrailIn_m,
                              [this](const Pose2& T_map) { return is_roomy(T_map); });
}

bool ExplorerNavigator::is_roomy(const Pose2& T_map) const {
  return search_.footprint_clearance().clearance_m(learner_.floor(), T_map) > kRoomy_m;
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

/// Whether the last path showed new floor.
bool ExplorerNavigator::was_worth_it() const {
  return learner_.floor().grid().free_m2() > searched_m2_ + kShown_m2;
}

void ExplorerNavigator::take_path() {
  is_wedged_ = false;
  const Path found = target_search_.path();
  path_end_ = target_search_.leads_home() ? PathEnd::kHome
              : search_.is_stage()        ? PathEnd::kStage
                                          : PathEnd::kElsewhere;
  search_.stop();
  const bool probes = std::exchange(tries_.probe, false);
  if (found.empty()) return arrive();
  if (probes) return take_probe(found);
  if (target_->kind == ExploringTarget::Kind::kPath)
    retry_budget_.allow(timer_.now_s(), learner_.path_m(), found.length_m());
  driver_.take(found, target_search_.trail_m());
  become(ExploringEvent::kPathFound);
}

/// Drives the first leg: then it has seen more, and may need to cross no unknown floor any more.
void ExplorerNavigator::take_probe(const Path& found) {
  driver_.take_trail(found);
  driver_.shorten(kProbe_m);
  path_end_ = PathEnd::kElsewhere;
  become(ExploringEvent::kProbeFound);
}

/// A vehicle that was put across a corridor may have seen too little floor to turn on.
bool ExplorerNavigator::may_probe() const {
  return is_where_put_ && tries_.failures > 0 && !tries_.probe && !driver_.has_path();
}

/// Either no path leads to the target, or none leads away from where the vehicle stands; that does not count
/// against the target.
void ExplorerNavigator::find_no_path() {
  is_wedged_ = !search_.is_from_the_end() && search_.reached_m() < kWedged_m;
  search_.stop();
  arrived_cycle_ = cycle_;
  tries_.probe = may_probe();
  if (tries_.probe) return begin_search();
  if (!is_wedged_) count_failure();
  if (blocks_.blocked_direction()) {
    blocks_.unblock_direction();
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

/// A failed path home does not count: the vehicle must still come home.
void ExplorerNavigator::count_failure() {
  const bool goes_home = former_ && former_->kind == ExploringTarget::Kind::kHome;
  if (!goes_home) retry_budget_.count_failure(learner_.T_map_vehicle());
}

/// Drives back as it came, then searches again.
bool ExplorerNavigator::retreat() {
  if (driver_.has_path()) return false;
  const Path back = trail_.path_back(learner_.T_map_vehicle(), kRetreat_m,
                                     [this](const Pose2& T_map) { return is_roomy(T_map); });
  if (back.empty()) return false;
  driver_.take_trail(back);
  become(ExploringEvent::kTrailFound);
  want_search();
  return true;
}

}  // namespace aisle
