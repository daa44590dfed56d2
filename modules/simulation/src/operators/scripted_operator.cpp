#include "aisle/simulation/operators/scripted_operator.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "aisle/core/angle.hpp"
#include "aisle/geometry/polyline.hpp"
#include "operators/operator_path.hpp"

namespace aisle {
namespace {

constexpr double kTurnsBack_rad = 120 * kDegree;
constexpr double kBacksRound_rad = 60 * kDegree;
constexpr double kLegEnd_m = 0.1;
constexpr double kLegEndBlocked_m = 0.5;
constexpr double kCareInReverse = 0.5;  ///< of the usual wander
constexpr double kCreep_mps = 0.05;
constexpr double kSlowest_mps = 0.02;
constexpr double kBraking_mps2 = 0.15;
constexpr double kKeptFree_m = 0.1;
constexpr double kAtWall_m = 0.15;
constexpr double kStuck_s = 1.5;    ///< without progress
constexpr double kBackOff_m = 0.8;  ///< along the path
constexpr double kBackedOff_m = 0.1;
constexpr double kSlowlyAgain = 0.5;  ///< of the usual speed
constexpr double kBackingClearance_m = 0.01;
constexpr std::array kLikedClearances_m = {0.12, 0.1, 0.08, 0.06, 0.04, 0.02};
constexpr double kLookedAt_m = 0.7;  ///< along the path
constexpr double kTriedStep_rad = 2 * kDegree;
constexpr int kTriedSteps = 10;
constexpr double kTurnsOnTheSpot_rad = 40 * kDegree;
constexpr double kTurnGain_1_s = 1.5;

/// The pose at a length along a polyline; before and after it, on its straight continuation.
Pose2 pose_along(const std::vector<Vec2>& points, double along_m) {
  for (std::size_t i = 1;; ++i) {
    const Vec2 step = points[i] - points[i - 1];
    const double step_m = step.norm();
    if (along_m <= step_m || i + 1 == points.size()) {
      const Vec2 p = points[i - 1] + along_m / step_m * step;
      return {p.x(), p.y(), heading_of(step)};
    }
    along_m -= step_m;
  }
}

}  // namespace

void ScriptedOperatorParams::describe(FieldList& fields) {
  fields.real("speed_mps", speed_mps, {0.02, 5}, "on a straight segment");
  fields.real("look_ahead_m", look_ahead_m, {0.1, 5}, "how far ahead on the route the vehicle steers to");
  fields.real("reaction_s", reaction_s, {0, 2}, "delay from seeing to acting");
  fields.real("wander_m", wander_m, {0, 1}, "standard deviation of the lateral offset");
  fields.real("wander_time_s", wander_time_s, {0.5, 100}, "over which the wander comes and goes");
  fields.real("speed_wander", speed_wander, {0, 0.5}, "standard deviation of the speed, as a share");
  fields.real("place_radius_m", place_radius_m, {0.05, 5}, "how near a place must be passed to be named");
  fields.real("timeout_s", timeout_s, {1, 1000}, "how long to wait for an obstacle to go away");
}

ScriptedOperator::ScriptedOperator(const World& world, const VehicleDescription& vehicle,
                                   const ScriptedOperatorParams& params, std::uint64_t seed)
    : vehicle_(vehicle),
      params_(params),
      random_(seed),
      places_(world.places),
      walls_(world, with_clearance(vehicle.footprint, kAtWall_m)) {
  add_legs(world);
  if (vehicle.is_differential) return;
  for (const double clearance_m : kLikedClearances_m)
    walls_by_clearance_.emplace_back(world, with_clearance(vehicle.footprint, clearance_m));
}

void ScriptedOperator::add_legs(const World& world) {
  std::vector<Vec2> route = world.tour;
  route.erase(std::unique(route.begin(), route.end()), route.end());
  if (route.size() < 2) throw std::invalid_argument("a route needs two different points");
  Obstacles obstacles(world, with_clearance(vehicle_.footprint, kBackingClearance_m));
  OperatorPath path(world, vehicle_);
  legs_.push_back({.points = {route[0], route[1]}});
  for (std::size_t i = 2; i < route.size(); ++i) {
    const Vec2 corner = route[i - 1];
    const double turn_rad = std::abs(turn_between(corner - route[i - 2], route[i] - corner));
    const bool was_in_reverse = legs_.back().in_reverse;
    if (turn_rad > kTurnsBack_rad) {
      legs_.push_back({.points = {corner}, .in_reverse = !vehicle_.is_differential && !was_in_reverse});
    } else if (was_in_reverse && turn_rad > kBacksRound_rad) {
      if (const auto place = place_to_back_to(legs_.back(), route[i], path, obstacles)) {
        legs_.back().points.push_back(*place);
        legs_.push_back({.points = {*place}});
      }
    }
    legs_.back().points.push_back(route[i]);
  }
  for (Leg& leg : legs_) {
    leg.points = path.drivable(leg.points, leg.in_reverse);
    leg.length_m = polyline_length_m(leg.points);
  }
}

/// The place beyond the corner at the leg's end, as seen from `next`: from there the vehicle goes forwards to
/// `next`.
/// @return nullopt if there is not enough space
std::optional<Vec2> ScriptedOperator::place_to_back_to(const Leg& leg, const Vec2& next,
                                                       OperatorPath& to_drive, Obstacles& obstacles) const {
  constexpr double kStep_m = 0.1;
  const Vec2 corner = leg.points.back();
  const double beyond_m = 2 * turning_radius_m(vehicle_);
  const Vec2 place = corner - beyond_m * (next - corner).normalized();
  const std::vector<Vec2> path = to_drive.drivable({leg.points.end()[-2], corner, place}, true);
  const double path_m = polyline_length_m(path);
  for (int step = 0; step * kStep_m < path_m; ++step) {
    Pose2 T_world_vehicle = pose_along(path, step * kStep_m);
    T_world_vehicle.theta = wrap_angle(T_world_vehicle.theta + kPi);
    if (obstacles.touch(T_world_vehicle)) return std::nullopt;
  }
  return place;
}

double ScriptedOperator::share_done() const {
  double all_m = 0, done_m = 0;
  for (std::size_t i = 0; i < legs_.size(); ++i) {
    all_m += legs_[i].length_m;
    if (i < leg_) done_m += legs_[i].length_m;
  }
  if (leg_ < legs_.size()) done_m += std::clamp(along_m_, 0.0, legs_[leg_].length_m);
  return done_m / all_m;
}

/// Ornstein-Uhlenbeck processes; the lateral offset follows its pull smoothly, as hands do.
void ScriptedOperator::wander(double time_s) {
  const double fade = time_s / params_.wander_time_s;
  pull_lateral_ += -fade * pull_lateral_ + random_.normal(std::sqrt(2 * fade));
  pull_speed_ += -fade * pull_speed_ + random_.normal(std::sqrt(2 * fade));
  lateral_ += std::min(1.0, 3 * fade) * (pull_lateral_ - lateral_);
}

OperatorView ScriptedOperator::seen_a_moment_ago(const OperatorView& view) {
  views_.push_back(view);
  constexpr double kSlack_s = 1e-9;
  while (views_.size() > 1 && views_[1].stamp_s <= view.stamp_s - params_.reaction_s + kSlack_s) {
    views_.pop_front();
  }
  return views_.front();
}

/// Advances along the leg to its nearest point, never back.
void ScriptedOperator::follow(const Vec2& p_world) {
  constexpr double kStep_m = 0.02;
  const Leg& leg = legs_[leg_];
  const auto off_m = [&](double along_m) {
    return (pose_along(leg.points, along_m).position() - p_world).norm();
  };
  double nearest_m = along_m_;
  const double end_m = std::min(along_m_ + params_.look_ahead_m, leg.length_m);
  for (int step = 1; along_m_ + step * kStep_m <= end_m; ++step) {
    const double at_m = along_m_ + step * kStep_m;
    if (off_m(at_m) < off_m(nearest_m)) nearest_m = at_m;
  }
  along_m_ = nearest_m;
}

Vec2 ScriptedOperator::target() const {
  const Leg& leg = legs_[leg_];
  const Pose2 T_world_target = pose_along(leg.points, along_m_ + params_.look_ahead_m);
  const double care = leg.in_reverse ? kCareInReverse : 1;
  const double lateral_m = care * params_.wander_m * std::clamp(lateral_, -2.0, 2.0);
  return T_world_target * Vec2(0, lateral_m);
}

/// The arc through the target that starts along the vehicle, forwards or backwards.
Command ScriptedOperator::towards(const Vec2& p_vehicle_target, double speed_mps) const {
  const double curvature_1_m = 2 * p_vehicle_target.y() / p_vehicle_target.squaredNorm();
  if (!vehicle_.is_differential) {
    return {.speed_mps = speed_mps,
            .steering_rad = std::atan(vehicle_.front_steered.wheelbase_m * curvature_1_m)};
  }
  const double off_rad = heading_of(p_vehicle_target);
  if (std::abs(off_rad) > kTurnsOnTheSpot_rad) return {.turn_rate_rad_s = kTurnGain_1_s * off_rad};
  return {.speed_mps = speed_mps, .turn_rate_rad_s = curvature_1_m * speed_mps};
}

/// The steering nearest to the requested one that keeps the largest clearance possible, up to what a person
/// likes.
Command ScriptedOperator::clear_of_walls(const Pose2& T_world_vehicle, const Command& requested) {
  if (requested.speed_mps == 0) return requested;
  const double distance_m = std::copysign(kLookedAt_m, requested.speed_mps);
  const double max_rad = vehicle_.limits.steering_max_rad;
  for (Obstacles& walls : walls_by_clearance_) {
    for (int i = 0; i <= 2 * kTriedSteps; ++i) {
      const int steps = (i + 1) / 2, off = i % 2 == 0 ? -steps : steps;
      const double tried_rad = std::clamp(requested.steering_rad + off * kTriedStep_rad, -max_rad, max_rad);
      const double turn_rad = distance_m * std::tan(tried_rad) / vehicle_.front_steered.wheelbase_m;
      if (walls.free_share(T_world_vehicle, {distance_m, turn_rad}) == 1)
        return {.speed_mps = requested.speed_mps, .steering_rad = tried_rad};
    }
  }
  return requested;
}

double ScriptedOperator::wanted_speed_mps(const OperatorView& view) const {
  const Leg& leg = legs_[leg_];
  const double left_m = std::max(0.0, leg.length_m - along_m_);
  double speed_mps = params_.speed_mps * (1 + params_.speed_wander * std::clamp(pull_speed_, -2.0, 2.0));
  speed_mps = std::min(speed_mps, kCreep_mps + std::sqrt(2 * kBraking_mps2 * left_m));
  return cautious_speed_mps(view, comes_again() ? kSlowlyAgain * speed_mps : speed_mps, leg.in_reverse);
}

/// A speed at which it can stop before the obstacle ahead; negative in reverse.
double ScriptedOperator::cautious_speed_mps(const OperatorView& view, double speed_mps,
                                            bool in_reverse) const {
  const bool looks_where_it_drives = in_reverse ? view.speed_mps < 0 : view.speed_mps >= 0;
  if (looks_where_it_drives) {
    const double free_m = std::max(0.0, view.free_ahead_m - kKeptFree_m);
    speed_mps = std::min(speed_mps, std::sqrt(2 * kBraking_mps2 * free_m));
    if (speed_mps < kSlowest_mps) return 0;
  }
  return in_reverse ? -std::min(speed_mps, vehicle_.limits.reverse_speed_max_mps) : speed_mps;
}

/// Whether it has backed off and is not yet where it was before.
bool ScriptedOperator::comes_again() const {
  return leg_ == leg_before_ && along_m_ < along_before_m_;
}

bool ScriptedOperator::is_stuck_at_wall(const OperatorView& view) {
  return !vehicle_.is_differential && view.stamp_s - got_on_s_ > kStuck_s &&
         walls_.touch(view.T_world_vehicle);
}

/// Back along its path, until it is at the place or is blocked there, too.
Command ScriptedOperator::back_off(const OperatorView& view) {
  const Leg& leg = legs_[leg_];
  const Vec2 p_vehicle_back =
      view.T_world_vehicle.inverse() * pose_along(leg.points, *backs_to_m_).position();
  const double left_m = leg.in_reverse ? p_vehicle_back.x() : -p_vehicle_back.x();
  const double speed_mps = cautious_speed_mps(view, kSlowlyAgain * params_.speed_mps, !leg.in_reverse);
  if (left_m > kBackedOff_m && speed_mps != 0) return towards(p_vehicle_back, speed_mps);
  along_m_ = *backs_to_m_;
  backs_to_m_.reset();
  return {};
}

std::vector<Mark> ScriptedOperator::passed_places(const Pose2& T_world_vehicle) {
  std::vector<Mark> marks;
  std::erase_if(places_, [&](const NamedPlace& place) {
    const double off_m = (place.T_world_place.position() - T_world_vehicle.position()).norm();
    if (off_m > params_.place_radius_m) return false;
    marks.push_back({Mark::Kind::kPlace, place.name});
    return true;
  });
  return marks;
}

bool ScriptedOperator::has_timed_out(double now_s) {
  constexpr double kGotOn_m = 0.1;
  if (leg_ != leg_before_ || along_m_ > along_before_m_ + kGotOn_m) {
    leg_before_ = leg_;
    along_before_m_ = along_m_;
    got_on_s_ = now_s;
  }
  return now_s - got_on_s_ > params_.timeout_s;
}

OperatorInput ScriptedOperator::look(const OperatorView& view) {
  wander(view.stamp_s - std::exchange(stamp_s_, view.stamp_s));
  const OperatorView seen = seen_a_moment_ago(view);
  OperatorInput input{.marks = passed_places(view.T_world_vehicle)};
  if (has_arrived() || has_timed_out(view.stamp_s)) {
    if (has_arrived()) input.marks.push_back({Mark::Kind::kStop, ""});
    input.quit = true;
    input.gives_up = !has_arrived();
    return input;
  }
  if (backs_to_m_) {
    input.requested = clear_of_walls(view.T_world_vehicle, back_off(view));
    return input;
  }
  follow(seen.T_world_vehicle.position());
  Command requested = clear_of_walls(
      view.T_world_vehicle, towards(seen.T_world_vehicle.inverse() * target(), wanted_speed_mps(view)));
  // Where the way is blocked just before a leg's end, that is near enough.
  const double left_m = legs_[leg_].length_m - along_m_;
  const bool stands = requested.speed_mps == 0 && requested.turn_rate_rad_s == 0;
  if (left_m < (stands ? kLegEndBlocked_m : kLegEnd_m)) {
    ++leg_;
    along_m_ = 0;
    requested = {.steering_rad = requested.steering_rad};
  } else if (stands && is_stuck_at_wall(view)) {
    backs_to_m_ = std::max(0.0, along_m_ - kBackOff_m);
  }
  input.requested = requested;
  return input;
}

}  // namespace aisle
