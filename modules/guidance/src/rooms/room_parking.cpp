/// How RoomNavigator parks at the end of its path.

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "aisle/guidance/rooms/room_navigator.hpp"
#include "aisle/guidance/rooms/route_floor.hpp"

namespace aisle {
namespace {

/// Size of the area where a frame's lines may look like edges of the route.
Vec2 about_lines(const Vec2& frame_size_m) {
  constexpr double kAboutLines_m = 0.15;
  return frame_size_m + 2 * Vec2(kAboutLines_m, kAboutLines_m);
}

}  // namespace

void RoomNavigator::look_for_frame(const Observation& observation) {
  const double astray_m = place_.is_sure() ? params_.frame_astray_m : std::numeric_limits<double>::infinity();
  frame_->look(observation, T_odom_vehicle(), place_.T_map_odom().inverse() * T_map_taught_frame(), astray_m);
  if (state_ == State::kFollowing && frame_->sees_frame()) state_ = State::kParkingInFrame;
}

Decision RoomNavigator::park_in_frame(double now_s) {
  forget_frame_lines();
  if (frame_backing_ && -frame_->off().x < params_.frame_backing.turn_from_m) {
    state_ = State::kBackingIntoFrame;
    learn_floor_before_frame();
    return back_into_frame(now_s);
  }
  return unless_obstructed(frame_->step(), now_s);
}

/// While it turns about, it avoids obstacles by the known floor.
Decision RoomNavigator::back_into_frame(double now_s) {
  forget_frame_lines();
  if (frame_backing_->wants_floor()) learn_floor_before_frame();
  frame_backing_->see(edges_.seen_around(T_odom_vehicle()), T_odom_vehicle());
  Decision decision = frame_backing_->step(now_s, T_odom_vehicle(), *frame_->frame(), steering_rad_);
  return frame_backing_->keeps_to_floor() ? decision : unless_obstructed(std::move(decision), now_s);
}

Pose2 RoomNavigator::T_map_taught_frame() const {
  const Footprint& footprint = vehicle_.footprint;
  return route_.path.end() * Pose2{(footprint.front_m - footprint.rear_m) / 2, 0, 0};
}

/// The taught end lies in the frame, whatever the edges say.
Pose2 RoomNavigator::T_map_odom_by_frame() const {
  constexpr double kAgree_m = 0.2;
  const Pose2 T_map_frame = T_map_taught_frame();
  const Pose2 T_map_odom = T_map_frame * frame_->frame()->inverse();
  const Vec2 p_map_frame = place_.T_map_odom() * frame_->frame()->position();
  const bool agrees = (p_map_frame - T_map_frame.position()).norm() < kAgree_m;
  return place_.is_sure() && agrees ? place_.T_map_odom() : T_map_odom;
}

/// The taught floor; while it turns about, it adds obstacles that it sees.
void RoomNavigator::learn_floor_before_frame() {
  constexpr double kAboutFrame_m = 4;
  const Pose2 T_map_odom = T_map_odom_by_frame();
  const Pose2 T_map_frame = T_map_odom * *frame_->frame();
  std::vector<RouteEdge> edges = route_.room->edges;
  std::erase_if(edges, [&](const RouteEdge& edge) {
    const Vec2 p_frame = T_map_frame.inverse() * edge.p_map;
    return (p_frame.cwiseAbs() - about_lines(frame_->size_m()) / 2).maxCoeff() < 0;
  });
  frame_backing_->begin(
      route_floor(route_.path, edges, vehicle_.footprint, T_map_frame.position(), kAboutFrame_m), T_map_odom);
}

/// The frame's lines look like edges of the route, but are not.
void RoomNavigator::forget_frame_lines() {
  edges_.clear(*frame_->frame(), about_lines(frame_->size_m()));
}

Decision RoomNavigator::unless_obstructed(Decision decision, double now_s) {
  if (decision.status != NavigatorStatus::kGoing || decision.command.speed_mps == 0) return decision;
  const SteeringChoice choice = free_path(vehicle_, params_.steering, edges_.around(T_odom_vehicle()),
                                          decision.command.steering_rad, gear_of(decision.command.speed_mps));
  if (choice.free_m >= params_.stop_free_m) {
    stopped_s_.reset();
    return decision;
  }
  if (!stopped_s_) stopped_s_ = now_s;
  const bool is_lasting = now_s - *stopped_s_ > params_.blind_max_s;
  return {.status = is_lasting ? NavigatorStatus::kFailed : NavigatorStatus::kGoing,
          .state = "waiting",
          .why = "something is in the path to the frame"};
}

/// Backs off for another try at the taught place.
Decision RoomNavigator::leave_place() {
  Command command = taught_place_.back_off(pose(), steering_rad_);
  const SteeringChoice choice = choose_steering_behind(command.steering_rad);
  command.steering_rad = choice.steering_rad;
  taught_place_.judge_path_back(pose(), choice.free_m);
  if (taught_place_.is_backing()) return {.command = command, .state = "backing off"};
  state_ = State::kFollowing;
  return {.state = "backing off"};
}

/// From the bumper to the nearest edge straight ahead.
double RoomNavigator::gap_ahead_m() const {
  double gap_m = std::numeric_limits<double>::infinity();
  for (const Vec2& p : edges_.around(T_odom_vehicle())) {
    if (std::abs(p.y()) < vehicle_.footprint.width_m / 2 && p.x() > 0)
      gap_m = std::min(gap_m, p.x() - vehicle_.footprint.front_m);
  }
  return gap_m;
}

/// L96 section 2.4, and near enough to the taught end.
bool RoomNavigator::is_at_dead_end() const {
  constexpr double kNearEnd_m = 1;
  return left_m() < kNearEnd_m && sight()->share < params_.dead_end_share &&
         (is_brightness_off_ || gap_ahead_m() < params_.dead_end_gap_m);
}

/// Where the view has opened again, the dead end has been taken for route.
bool RoomNavigator::is_beyond_dead_end() const {
  constexpr double kOpenBeyond_m = 0.1;
  const bool is_open = sight()->share >= params_.dead_end_share;
  return -left_to_end_m() > (is_open ? kOpenBeyond_m : params_.dead_end_beyond_m);
}

bool RoomNavigator::is_place_taken() const {
  const Pose2 T_due_vehicle = between(route_.path.end(), pose());
  const std::vector<Vec2> around = edges_.around(T_odom_vehicle());
  return std::any_of(around.begin(), around.end(), [&](const Vec2& p) {
    return off_footprint_m(vehicle_.footprint, T_due_vehicle * p) < params_.steering.margin_m;
  });
}

/// Path left to the end of the route; near the end, along the last leg and negative beyond it.
double RoomNavigator::left_to_end_m() const {
  const double straight_m = between(pose(), route_.path.end()).x;
  constexpr double kLastLeg_m = 1;
  return left_m() > kLastLeg_m ? left_m() : straight_m;
}

bool RoomNavigator::has_confirmed_place() const {
  return route_.room->parking != ParkingStrategy::kView || place_.is_sure() || stop_views_.has_matched();
}

int RoomNavigator::parking_tries() const {
  if (frame_backing_) return frame_backing_->tries();
  return frame_ ? frame_->tries() : taught_place_.tries();
}

std::optional<Decision> RoomNavigator::arrived() {
  const Decision done{.status = NavigatorStatus::kDone, .state = "parked"};
  const Decision unconfirmed{.status = NavigatorStatus::kDone,
                             .state = "parked",
                             .why = "not confirmed: neither edges nor views are as they were taught"};
  switch (route_.room->parking) {
    case ParkingStrategy::kDeadEnd:
      if (dead_end_images_ >= params_.dead_end_images) return done;
      if (is_beyond_dead_end())
        return Decision{.status = NavigatorStatus::kFailed,
                        .state = "no dead end",
                        .why = "does not see what ends the route"};
      break;
    case ParkingStrategy::kFrame:
      if (progress_.has_arrived())
        return Decision{
            .status = NavigatorStatus::kFailed, .state = "no frame", .why = "does not see the frame"};
      break;
    case ParkingStrategy::kView: {
      // Edges of the floor, where they fit, are more accurate than brightness columns.
      const double shift_m = place_.is_sure() ? 0 : stop_views_.shift_m();
      if (left_to_end_m() + shift_m <= vehicle_.cycle_s * params_.parking_speed_mps) {
        if (!has_confirmed_place()) return unconfirmed;
        if (!place_.is_sure()) return done;
        const Decision decision = taught_place_.settle(pose(), is_place_taken());
        if (taught_place_.is_backing()) {
          learn_floor_behind();
          state_ = State::kLeavingPlace;
        }
        return decision;
      }
      break;
    }
  }
  return std::nullopt;
}

}  // namespace aisle
