#include "aisle/guidance/exploration/explorer_navigator.hpp"

#include <fmt/format.h>

#include <utility>

#include "aisle/vehicle/odometry_step.hpp"

namespace aisle {
namespace {

constexpr double kCoverageEvery_m = 0.5;
constexpr int kHomeAttemptsMax = 4;
constexpr double kLeft_m = 2;              // so far from home it has left where it was put
constexpr double kContactKnown_m = -0.03;  // with less clearance, the floor shows what was touched

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
      timer_(params.time_max_s, params.stuck_s),
      retry_budget_(params.retry_budget) {}

Decision ExplorerNavigator::step(const Observation& observation) {
  if (phase_ == ExploringPhase::kGivenUp) return ended_;
  const FloorLearner::News news = sense(observation);
  if (contacts_.touches(observation.bumper_pressed)) return back_off(observation);
  note_contact();
  if (timer_.is_over()) return end(NavigatorStatus::kFailed, "late", "its time is over");
  if (learner_.is_rebuilding()) return wait_for_floor();
  keep_trail(news);
  if (phase_ == ExploringPhase::kLooking && !has_looked_around()) return {.state = "looking"};
  if (phase_ == ExploringPhase::kHome) return end(NavigatorStatus::kDone, "home", what_was_explored());
  plan(news);
  leave_what_costs_too_much();
  return phase_ == ExploringPhase::kGivenUp ? ended_ : drive(observation);
}

FloorLearner::News ExplorerNavigator::sense(const Observation& observation) {
  ++cycle_;
  timer_.tick(observation.stamp_s);
  const FloorLearner::News news = learner_.take(observation);
  driver_.see(learner_.sensor().scanner(), learner_.view().ranges_m);
  mark_coverage();
  return news;
}

bool ExplorerNavigator::has_looked_around() {
  if (timer_.since_begin_s() < params_.look_s || !learner_.has_looked()) return false;
  become(ExploringEvent::kLookedAround);
  return true;
}

/// After a loop closure, or with cells halved, the floor is rebuilt while the vehicle stands.
Decision ExplorerNavigator::wait_for_floor() {
  drop_path();
  timer_.note_progress();
  return {.state = "laying floor again"};
}

Decision ExplorerNavigator::end(NavigatorStatus status, std::string state, std::string why) {
  if (status == NavigatorStatus::kFailed) become(ExploringEvent::kGaveUp);
  ended_ = {.status = status, .state = std::move(state), .why = std::move(why)};
  return ended_;
}

std::string ExplorerNavigator::what_was_explored() const {
  const std::size_t undone = explorer_.paths_abandoned();
  const std::string explored = undone == 0
                                   ? "explored"
                                   : fmt::format("came home with {} left undone",
                                                 undone == 1 ? "a path" : fmt::format("{} paths", undone));
  return contacts_.count() == 0 ? explored : explored + ", but touched something";
}

/// Stops, and looks for another path, away from what it touched.
Decision ExplorerNavigator::back_off(const Observation& observation) {
  if (contacts_.are_too_many() || !learner_.has_looked())
    return end(NavigatorStatus::kFailed, "bumped", "the bumper is pressed");
  be_blocked(contacts_.driven_direction());
  return {.command = {.steering_rad = steering_rad_of(observation.odometry)}, .state = "touched"};
}

/// It touched something right where it stopped; notes that on the floor unless the floor shows it already.
void ExplorerNavigator::note_contact() {
  const std::optional<Gear> gear = contacts_.stopped_after_contact(learner_.is_standing());
  if (!gear) return;
  const double clearance_m =
      search_.footprint_clearance().standing_clearance_m(learner_.floor(), learner_.T_map_vehicle());
  if (clearance_m > kContactKnown_m) learner_.add_contact(*gear);
}

void ExplorerNavigator::be_blocked(std::optional<LegDirection> direction) {
  count_failure();
  blocks_.note(learner_.T_map_vehicle(), direction);
  drop_path();
}

void ExplorerNavigator::keep_trail(FloorLearner::News news) {
  if (!learner_.has_looked()) return;
  const Pose2 T_home_vehicle = between(learner_.T_map_home(), learner_.T_map_vehicle());
  if (T_home_vehicle.position().norm() > kLeft_m) is_where_put_ = false;
  if (news == FloorLearner::News::kLoop) trail_.lay_again(learner_.T_map_vehicle_of_all());
  if (phase_ == ExploringPhase::kRetreating) return trail_.go_back(learner_.T_map_vehicle());
  trail_.go_on(learner_.T_map_vehicle(), learner_.log().scans.size() - 1);
}

void ExplorerNavigator::mark_coverage() {
  if (!coverage_.empty() && learner_.path_m() - coverage_.back().path_m < kCoverageEvery_m) return;
  coverage_.push_back({learner_.path_m(), learner_.floor().grid().free_m2()});
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
      if (path_end_ == PathEnd::kHome && driver_.left_m() < HomeSearch::kLast_m) {
        arrive();
        break;
      }
      be_blocked(step.direction);
      return {.command = step.command, .state = "blocked"};
    case PathDriver::State::kTurningWheels:
      break;
    case PathDriver::State::kDriving:
      contacts_.note_driving(*step.direction);
      break;
  }
  return {.command = step.command, .state = state};
}

void ExplorerNavigator::arrive() {
  driver_.drop();
  become(ExploringEvent::kPathEnded);
  arrived_cycle_ = cycle_;
  if (target_ && target_->kind == ExploringTarget::Kind::kCrossing) return target_.reset();
  if (path_end_ != PathEnd::kHome) return;
  learner_.settle_home();
  const bool is_there = stands_at_home(learner_.T_map_home(), learner_.T_map_vehicle());
  if (!is_there && tries_.paths < kHomeAttemptsMax) return;
  become(ExploringEvent::kCameHome);
  explorer_.stop(cycle_);
}

/// Keeps only the next path segment.
void ExplorerNavigator::shorten_path(double ahead_m) {
  driver_.shorten(ahead_m);
  if (path_end_ == PathEnd::kHome) path_end_ = PathEnd::kElsewhere;
}

void ExplorerNavigator::drop_path() {
  driver_.drop();
  search_.stop();
  become(ExploringEvent::kPathDropped);
  target_.reset();
  search_due_ = SearchDue::kNo;
  path_end_ = PathEnd::kElsewhere;
}

std::string ExplorerNavigator::state_word() const {
  if (phase_ == ExploringPhase::kRetreating) return "retreating";
  if (phase_ == ExploringPhase::kProbing) return "probing";
  if (phase_ != ExploringPhase::kDriving) return "searching";
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

ExplorationRecord ExplorerNavigator::record() const {
  ExplorationRecord record;
  record.paths = explorer_.events();
  record.steps = explorer_.steps();
  record.coverage = coverage_;
  record.T_map_vehicle = learner_.T_map_vehicle_of_all();
  record.paths_waiting = explorer_.paths_waiting();
  record.paths_abandoned = explorer_.paths_abandoned();
  record.path_m = learner_.path_m();
  record.came_home = phase_ == ExploringPhase::kHome;
  record.ended_because = ended_.why;
  return record;
}

}  // namespace aisle
