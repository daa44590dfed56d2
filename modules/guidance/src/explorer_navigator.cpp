#include "aisle/guidance/explorer_navigator.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "aisle/vehicle/odometry_step.hpp"

namespace aisle {
namespace {

constexpr double kStopSpare_m = 0.15;  // the vehicle stops so far before what came into its way
constexpr double kCoverageEvery_m = 0.5;
constexpr double kFanEdge_rad = 3 * kDegree;  // nothing is expected to be seen so near to the fan's edge
constexpr int kAttemptsMax = 3;
constexpr double kNearHome_m = 1.5;
constexpr double kNearHome_rad = 30 * kDegree;
constexpr double kGateMoved_m = 1;
constexpr double kSameSpot_m = 0.2;   // about a place where the vehicle was blocked
constexpr double kStruckNow_m = 1.5;  // so far from the vehicle ways keep off what is struck now
constexpr double kStageLeft_m = 2.5;  // of a stage, when the next one is searched
constexpr double kBendAhead_m = 0.05;
constexpr double kWheelsOff_rad = 25 * kDegree;
constexpr double kWheelsOffAtFirst_rad = 4 * kDegree;  // at the start of a leg
constexpr double kLearned_m2 = 0.5;                    // so much more floor is something learned
constexpr double kIdleWay_m = 150;                     // without learning anything: what waits is left undone
constexpr double kWatchMargin_m = 0.02;                // around the footprint, while it is driven

/// The path up to a point.
Path cut_at(const Path& path, double along_m) {
  std::vector<PathPiece> pieces;
  for (PathPiece piece : path.pieces()) {
    const double left_m = along_m - path.start_m(pieces.size());
    if (left_m <= 0 && !pieces.empty()) break;
    if (left_m < piece.way_m()) {
      const double share = std::max(left_m, 1e-3) / piece.way_m();
      piece.arc = {piece.arc.length_m * share, piece.arc.turn_rad * share};
    }
    pieces.push_back(piece);
  }
  return Path(std::move(pieces));
}

Path joined(const Path& a, const Path& b) {
  std::vector<PathPiece> pieces = a.pieces();
  pieces.insert(pieces.end(), b.pieces().begin(), b.pieces().end());
  return Path(std::move(pieces));
}

/// Nothing stands, and nothing is unknown, between two places.
bool is_clear(const FloorGrid& floor, const Vec2& from, const Vec2& to, double spare_m) {
  const Vec2 way = to - from;
  const double length_m = way.norm();
  const double step_m = floor.cell_m() / 2;
  const int steps = static_cast<int>(std::ceil((length_m - spare_m) / step_m));
  for (int i = 0; i < steps; ++i) {
    const double along_m = i * step_m;
    if (floor.at(Vec2(from + way * (along_m / length_m))) != Floor::kFree) return false;
  }
  return true;
}

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
  fields.real("look_from_m", look_from_m, {0.3, 10}, "so near it drives to what it wants to see");
  fields.real("join_m", join_m, {0.1, 5}, "so far ahead a new way joins the old one");
  fields.group("patience", patience);
  fields.real("time_max_s", time_max_s, {10, 100000}, "then it gives up, wherever it is");
  fields.count("expansions", expansions, {10, 100000}, "poses that the search looks at in a cycle");
  fields.real("stuck_s", stuck_s, {1, 3600}, "standing for so long without a way it gives up");
}

ExplorerNavigator::ExplorerNavigator(const ExplorerNavigatorParams& params, const VehicleDescription& vehicle,
                                     ExploringOrder order, std::unique_ptr<SliceSensor> sensor)
    : params_(params),
      vehicle_(vehicle),
      learner_(params.learner, vehicle, std::move(sensor)),
      explorer_(params.explorer, order),
      search_(params.search, vehicle),
      watch_(vehicle.footprint, kWatchMargin_m),
      braking_(vehicle, kWatchMargin_m),
      patience_(params.patience),
      follower_(vehicle, params.steering) {}

Decision ExplorerNavigator::step(const Observation& observation) {
  ++cycle_;
  stamp_s_ = observation.stamp_s;
  if (!begun_s_) begun_s_ = moved_s_ = stamp_s_;
  if (observation.bumper_pressed) return end(NavigatorStatus::kFailed, "bumped", "the bumper is pressed");
  const FloorLearner::News news = learner_.take(observation);
  braking_.see(learner_.sensor().fan(), learner_.view().ranges_m);
  mark_coverage();
  if (stamp_s_ - *begun_s_ > params_.time_max_s)
    return end(NavigatorStatus::kFailed, "late", "its time is over");
  if (learner_.is_laying_anew()) return wait_for_floor();
  if (stamp_s_ - *begun_s_ < params_.look_s || !learner_.has_looked()) return {.state = "looking"};
  if (news == FloorLearner::News::kLoop) drop_way();
  if (news != FloorLearner::News::kNothing || !target_) {
    check_way();
    choose();
  }
  search_way();
  lose_patience();
  if (!ended_because_.empty()) return end(NavigatorStatus::kFailed, "stuck", ended_because_);
  if (is_lost_for_ways()) return end(NavigatorStatus::kFailed, "stuck", "finds no way that it can drive");
  if (came_home_) return end(NavigatorStatus::kDone, "home", "explored");
  return drive(observation);
}

void ExplorerNavigator::mark_coverage() {
  if (!coverage_.empty() && learner_.way_m() - coverage_.back().way_m < kCoverageEvery_m) return;
  coverage_.push_back({learner_.way_m(), learner_.floor().free_m2()});
}

/// C99's steps 9 and 10: what is around is encoded, the transducer says where to go.
void ExplorerNavigator::choose() {
  const double middle_m = (vehicle_.footprint.front_m - vehicle_.footprint.rear_m) / 2;
  const ExploringTarget target =
      explorer_.decide(learner_.floor(), learner_.clearance(), learner_.T_map_vehicle(),
                       learner_.T_map_vehicle() * Vec2(middle_m, 0), learner_.T_map_home(), cycle_);
  const bool goes_on = target_ && is_same(*target_, target);
  watch_learning(target);
  target_ = former_ = target;
  const bool gate_moved = (target.gate.p_map - p_map_searched_).norm() > kGateMoved_m;
  if (goes_on && (!gate_moved || target.kind != ExploringTarget::Kind::kPath)) return;
  attempts_ = 0;
  is_search_due_ = true;
}

/// From where the present way is left: ahead, so that the vehicle need not stop.
void ExplorerNavigator::begin_search() {
  is_search_due_ = stands_first_ = false;
  p_map_searched_ = target_->gate.p_map;
  if (progress_) shorten_way(params_.join_m);
  const Pose2 T_map_from = path_.empty() ? learner_.T_map_vehicle() : path_.at(path_.length_m()).T_map_path;
  begin_search_from(T_map_from);
  const double since_blocked_m = (T_map_from.position() - p_map_blocked_).norm();
  if (since_blocked_m < kSameSpot_m) search_.forbid_first(blocked_direction_);
  keep_off_struck();
}

/// What the sensor strikes now stands a little off where the floor's cells show it.
void ExplorerNavigator::keep_off_struck() {
  search_.keep_to([this](const Pose2& T_map_later) {
    const Pose2 T_vehicle_later = between(learner_.T_map_vehicle(), T_map_later);
    return T_vehicle_later.position().norm() > kStruckNow_m || braking_.is_off_struck(T_vehicle_later);
  });
}

void ExplorerNavigator::begin_search_from(const Pose2& T_map_from) {
  switch (target_->kind) {
    case ExploringTarget::Kind::kPath:
      return search_.look_for(learner_.floor(), learner_.clearance(), T_map_from, target_->gate.p_map,
                              look_from_m() + vehicle_.footprint.front_m,
                              [this](const Pose2& T_map) { return sees_rim(T_map); });
    case ExploringTarget::Kind::kCrossing: {
      const Vec2 p_map_back = target_->T_map_back.position();
      const double near_m = params_.explorer.crossing_near_m / 2;
      return search_.look_for(
          learner_.floor(), learner_.clearance(), T_map_from, p_map_back, 0,
          [=](const Pose2& T_map) { return (T_map.position() - p_map_back).norm() < near_m; });
    }
    case ExploringTarget::Kind::kHome:
      return begin_search_home(T_map_from);
  }
}

/// Exactly home; where no such way is found, near home first, and on from there.
void ExplorerNavigator::begin_search_home(const Pose2& T_map_from) {
  const Pose2 T_map_home = learner_.T_map_home();
  is_exactly_home_ = attempts_ % 2 == 0;
  if (is_exactly_home_) {
    search_.look_for_way_to(learner_.floor(), learner_.clearance(), T_map_home, T_map_from);
    if (search_.is_stage() || !progress_) return;
    search_.stop();
    is_search_due_ = stands_first_ = true;
    return;
  }
  search_.look_for(learner_.floor(), learner_.clearance(), T_map_from, T_map_home.position(), kNearHome_m,
                   [T_map_home](const Pose2& T_map) {
                     const Pose2 off = between(T_map_home, T_map);
                     return off.position().norm() < kNearHome_m && std::abs(off.theta) < kNearHome_rad;
                   });
}

/// Before a stage ends, the way on from it is searched.
void ExplorerNavigator::search_on() {
  const bool ends_soon =
      is_stage_ && progress_ && path_.length_m() - progress_->point().along_m < kStageLeft_m;
  if (!ends_soon || search_.state() != CarSearch::State::kIdle) return;
  is_stage_ = false;
  is_search_due_ = true;
}

double ExplorerNavigator::look_from_m() const {
  return attempts_ < 2 ? params_.look_from_m : params_.look_from_m / 2;
}

/// Whether enough of what is to be seen of the path would be seen from there.
bool ExplorerNavigator::sees_rim(const Pose2& T_map_vehicle) const {
  const LaserScanner& fan = learner_.sensor().fan();
  const Pose2 T_map_fan = T_map_vehicle * fan.T_vehicle_laser;
  const std::vector<Vec2>& rim = target_->gate.rim;
  const std::size_t enough = attempts_ == 0 ? (rim.size() + 3) / 4 : 1;
  std::size_t seen = 0;
  for (const Vec2& p_map : rim) {
    const Vec2 towards = p_map - T_map_fan.position();
    if (towards.norm() > look_from_m()) continue;
    const double angle_rad = wrap_angle(heading_of(towards) - T_map_fan.theta);
    if (angle_rad < fan.first_angle_rad + kFanEdge_rad || angle_rad > -fan.first_angle_rad - kFanEdge_rad)
      continue;
    const std::vector<float>& near_m = learner_.view().near_m;
    const auto beam = static_cast<std::size_t>((angle_rad - fan.first_angle_rad) / fan.angle_step_rad);
    if (beam < near_m.size() && towards.norm() < near_m[beam]) continue;
    if (!is_clear(learner_.floor(), T_map_fan.position(), p_map, 1.5 * learner_.floor().cell_m())) continue;
    if (++seen >= enough) return true;
  }
  return false;
}

void ExplorerNavigator::search_way() {
  if (!target_) return;
  search_on();
  if (is_search_due_ && (progress_ ? !stands_first_ : learner_.is_standing())) begin_search();
  if (search_.state() == CarSearch::State::kIdle && !progress_ && !is_search_due_) {
    if (cycle_ - arrived_cycle_ <= static_cast<std::size_t>(params_.learner.look_every_cycles)) return;
    if (++attempts_ > kAttemptsMax && target_->kind == ExploringTarget::Kind::kPath) return leave_path();
    begin_search();
  }
  if (search_.state() != CarSearch::State::kSearching) return;
  const auto state = search_.advance(learner_.floor(), learner_.clearance(), params_.expansions);
  if (state == CarSearch::State::kFound) take_way();
  if (state == CarSearch::State::kNone) {
    search_.stop();
    patience_.hitch(learner_.T_map_vehicle());
    arrived_cycle_ = cycle_;
    if (std::exchange(blocked_direction_, 0) != 0) return;
    if (target_->kind == ExploringTarget::Kind::kPath && attempts_ > 0) give_path_up();
  }
}

/// It went where it should have seen behind the gate, and did not: a corner is left out, more is left undone.
void ExplorerNavigator::leave_path() {
  if (target_->gate.behind_m2 < params_.explorer.leftover_m2) return give_path_up();
  explorer_.abandon(target_->path, cycle_);
  target_.reset();
  moved_s_ = stamp_s_;
}

void ExplorerNavigator::give_path_up() {
  explorer_.give_up(target_->path, cycle_);
  target_.reset();
  moved_s_ = stamp_s_;
}

/// New floor, or another target: that is worth its time.
void ExplorerNavigator::watch_learning(const ExploringTarget& target) {
  const bool goes_on = former_ && is_same(*former_, target);
  const bool learned = learner_.floor().free_m2() > learned_m2_ + kLearned_m2;
  if (learned) {
    learned_m2_ = learner_.floor().free_m2();
    learned_way_m_ = learner_.way_m();
  }
  if (!learned && goes_on) return;
  const bool is_home = target.kind == ExploringTarget::Kind::kHome;
  const double target_m = is_home ? learner_.way_m() / 2 : target.gate.way_m;
  patience_.renew(stamp_s_, learner_.way_m(), target_m);
}

/// What leads nowhere is left undone, and in the end everything.
void ExplorerNavigator::lose_patience() {
  if (!target_) return;
  const bool is_idle = learner_.way_m() - learned_way_m_ > kIdleWay_m;
  if (is_idle && target_->kind != ExploringTarget::Kind::kHome) {
    explorer_.abandon_all(cycle_);
    return drop_way();
  }
  if (!patience_.is_over(stamp_s_, learner_.way_m())) return;
  switch (target_->kind) {
    case ExploringTarget::Kind::kPath:
      explorer_.abandon(target_->path, cycle_);
      return drop_way();
    case ExploringTarget::Kind::kCrossing:
      ended_because_ = "does not get back to a crossing";
      return;
    case ExploringTarget::Kind::kHome:
      ended_because_ = "does not get home";
      return;
  }
}

/// A place was recognised: the floor is laid anew while the vehicle stands.
Decision ExplorerNavigator::wait_for_floor() {
  drop_way();
  moved_s_ = stamp_s_;
  return {.state = "recognising"};
}

void ExplorerNavigator::take_way() {
  const Path found = search_.path();
  is_stage_ = search_.is_stage();
  ends_at_home_ = target_->kind == ExploringTarget::Kind::kHome && is_exactly_home_ && !is_stage_;
  search_.stop();
  if (found.empty()) return arrive();
  if (!path_.empty() && progress_) {
    const double along_m = progress_->point().along_m;
    path_ = joined(path_, found);
    progress_.emplace(path_, along_m);
    return;
  }
  path_ = found;
  leg_begun_ = 0;
  progress_.emplace(path_);
}

void ExplorerNavigator::arrive() {
  progress_.reset();
  path_ = {};
  arrived_cycle_ = cycle_;
  if (!ends_at_home_) return;
  came_home_ = true;
  explorer_.stop(cycle_);
}

/// Keeps only the next stretch of the way, or what is left of the present leg.
void ExplorerNavigator::shorten_way(double ahead_m) {
  const double along_m = progress_->point().along_m;
  const std::size_t leg_end = path_.leg_end(progress_->point().piece);
  const double leg_end_m = path_.start_m(leg_end - 1) + path_.pieces()[leg_end - 1].way_m();
  path_ = cut_at(path_, std::min(along_m + ahead_m, leg_end_m));
  ends_at_home_ = false;
  progress_.emplace(path_, std::min(along_m, path_.length_m()));
}

void ExplorerNavigator::drop_way() {
  progress_.reset();
  path_ = {};
  search_.stop();
  target_.reset();
  is_search_due_ = false;
  is_stage_ = false;
  ends_at_home_ = false;
}

/// What was learned since may lie in the way.
void ExplorerNavigator::check_way() {
  if (!progress_) return;
  const double along_m = progress_->point().along_m;
  const double standing_m =
      watch_.standing_spare_m(learner_.floor(), learner_.clearance(), learner_.T_map_vehicle());
  const double free_m = watch_.free_way_m(learner_.floor(), learner_.clearance(), path_, along_m, standing_m);
  if (along_m + free_m >= path_.length_m() - 1e-6) return;
  if (free_m < kStopSpare_m) {
    patience_.hitch(learner_.T_map_vehicle());
    return drop_way();
  }
  shorten_way(free_m - kStopSpare_m);
  target_.reset();
}

bool ExplorerNavigator::is_lost_for_ways() {
  if (progress_) moved_s_ = stamp_s_;
  return stamp_s_ - moved_s_ > params_.stuck_s;
}

Decision ExplorerNavigator::drive(const Observation& observation) {
  const double steering_rad = steering_rad_of(observation.odometry);
  const std::string state = state_word();
  if (!progress_) return {.command = {.steering_rad = steering_rad}, .state = state};
  const PathPoint& point = progress_->advance(learner_.T_map_vehicle());
  if (progress_->has_arrived()) {
    if (search_.state() != CarSearch::State::kSearching) arrive();
    return {.command = {.steering_rad = steering_rad}, .state = state};
  }
  if (const auto turned = turn_wheels_first(point, steering_rad)) return {.command = *turned, .state = state};
  const double care = driving_care(vehicle_, search_.room(), learner_.floor(), learner_.clearance(), path_,
                                   point.along_m, steering_rad);
  const double speed_mps = speed_along(path_, point.along_m, care, vehicle_, params_.speed);
  const Command command = follower_.follow(path_, point, learner_.T_map_vehicle(), speed_mps, steering_rad);
  if (!braking_.is_free(learner_.floor(), learner_.clearance(), learner_.T_map_vehicle(), command,
                        steering_rad)) {
    patience_.hitch(learner_.T_map_vehicle());
    p_map_blocked_ = learner_.T_map_vehicle().position();
    blocked_direction_ = command.speed_mps > 0 ? 1 : -1;
    drop_way();
    return {.command = {.steering_rad = steering_rad}, .state = "blocked"};
  }
  return {.command = command, .state = state};
}

/// Where the way bends otherwise than the wheels stand, they turn before the vehicle goes on.
std::optional<Command> ExplorerNavigator::turn_wheels_first(const PathPoint& point, double steering_rad) {
  if (vehicle_.is_differential) return std::nullopt;
  const std::size_t leg_end = path_.leg_end(point.piece);
  const double leg_end_m = path_.start_m(leg_end - 1) + path_.pieces()[leg_end - 1].way_m();
  const PathPoint ahead = path_.at(std::min(point.along_m + kBendAhead_m, leg_end_m - 1e-6));
  const double wanted_rad = std::atan(ahead.curvature_per_m * vehicle_.front_steered.wheelbase_m);
  const double off_max_rad = leg_end == leg_begun_ ? kWheelsOff_rad : kWheelsOffAtFirst_rad;
  if (std::abs(wanted_rad - steering_rad) < off_max_rad) {
    leg_begun_ = leg_end;
    return std::nullopt;
  }
  return Command{.speed_mps = 0, .steering_rad = wanted_rad};
}

std::string ExplorerNavigator::state_word() const {
  if (!progress_) return "searching";
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
  record.way_m = learner_.way_m();
  record.came_home = came_home_;
  record.ended_because = ended_because_;
  return record;
}

}  // namespace aisle
