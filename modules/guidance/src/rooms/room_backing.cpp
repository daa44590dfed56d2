/// How RoomNavigator reverses where no camera looks: over known floor.

#include <algorithm>
#include <cmath>
#include <vector>

#include "aisle/guidance/rooms/room_navigator.hpp"
#include "aisle/guidance/rooms/route_floor.hpp"

namespace aisle {

void RoomNavigator::remember_driven() {
  constexpr double kApart_m = 0.1;
  const auto far_m = [&](const Pose2& T_odom) { return between(T_odom, T_odom_vehicle()).position().norm(); };
  if (!T_odom_driven_.empty() && far_m(T_odom_driven_.back()) < kApart_m) return;
  std::erase_if(T_odom_driven_, [&](const Pose2& T_odom) { return far_m(T_odom) > kReach_m; });
  T_odom_driven_.push_back(T_odom_vehicle());
}

/// The taught floor, and where the vehicle has driven in this run.
void RoomNavigator::learn_floor_behind() {
  FloorGrid floor =
      route_floor(route_.path, route_.room->edges, vehicle_.footprint, pose().position(), kReach_m);
  for (const Pose2& T_odom : T_odom_driven_)
    free_under(vehicle_.footprint, place_.T_map_odom() * T_odom, floor);
  free_under(vehicle_.footprint, pose(), floor);
  p_map_limit_ = limit_of_known(floor);
}

/// Obstacles by this run's images and by teaching, and the limit of the known floor.
std::vector<Vec2> RoomNavigator::standing_behind() const {
  std::vector<Vec2> around = edges_.around(T_odom_vehicle());
  const Pose2 T_vehicle_map = pose().inverse();
  for (const Vec2& p : place_.taught().around(pose().position(), kReach_m))
    around.push_back(T_vehicle_map * p);
  for (const Vec2& p : p_map_limit_) around.push_back(T_vehicle_map * p);
  return around;
}

SteeringChoice RoomNavigator::choose_steering_behind(double requested_rad) const {
  FreeSteeringParams steering = params_.steering;
  steering.comfort_m = params_.end_comfort_m;
  return choose_steering(vehicle_, steering, standing_behind(), requested_rad, Gear::kReverse);
}

void RoomNavigator::begin_to_back_off() {
  T_odom_stopped_ = T_odom_vehicle();
  learn_floor_behind();
  path_back_ = choose_path_back();
  state_ = State::kBackingOff;
}

/// The steering angle that leads back nearest to the taught path.
SteeringChoice RoomNavigator::choose_path_back() const {
  constexpr double kLateralWeight_per_m = 1, kTurnedWeight_per_rad = 1, kShortWeight_per_m = 4;
  const double max_rad = vehicle_.limits.steering_max_rad;
  const int steps = static_cast<int>(max_rad / params_.steering.step_rad);
  const std::vector<Vec2> around = standing_behind();
  SteeringChoice best;
  double least = -1;
  for (int i = -steps; i <= steps; ++i) {
    const double steering_rad = i * params_.steering.step_rad;
    const SteeringChoice choice = free_path(vehicle_, params_.steering, around, steering_rad, Gear::kReverse);
    const double back_m = std::min(params_.back_off_m, choice.free_m);
    const double turn_rad = -back_m * std::tan(steering_rad) / vehicle_.front_steered.wheelbase_m;
    const Pose2 T_map_then = pose() * end_pose({-back_m, turn_rad});
    const double along_m = progress_.point().along_m;
    const PathPoint there = route_.path.nearest(T_map_then.position(), along_m - 2 * params_.back_off_m,
                                                along_m + params_.back_off_m);
    const double cost =
        kLateralWeight_per_m * std::abs(there.lateral_m) +
        kTurnedWeight_per_rad * std::abs(wrap_angle(T_map_then.theta - there.T_map_path.theta)) +
        kShortWeight_per_m * (params_.back_off_m - back_m);
    if (least >= 0 && cost >= least) continue;
    least = cost;
    best = choice;
  }
  return best;
}

Decision RoomNavigator::back_off(double now_s) {
  const double backed_m = (T_odom_vehicle().position() - T_odom_stopped_.position()).norm();
  if (backed_m >= std::min(params_.back_off_m, path_back_.free_m - params_.stop_free_m)) {
    state_ = State::kFollowing;
    stopped_s_ = now_s;
    return {.state = "backing off"};
  }
  return {.command = {.speed_mps = -params_.parking_speed_mps, .steering_rad = path_back_.steering_rad},
          .state = "backing off"};
}

}  // namespace aisle
