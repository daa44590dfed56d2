#include "aisle/control/steering.hpp"

#include <algorithm>
#include <cmath>

#include "aisle/control/reversing.hpp"
#include "least_on_grid.hpp"
#include "wheel_paths.hpp"

namespace aisle {
namespace {

/// How much of the path before and after the vehicle matters: its wheels cannot get past it within the
/// look-ahead, however large the lateral offset.
double reach_m(const FrontSteered& vehicle, double look_ahead_m) {
  return 2 * look_ahead_m + std::abs(vehicle.wheelbase_m);
}

double cost(const WheelPaths& paths, const FrontSteered& vehicle, const Pose2& T_map_vehicle,
            double look_ahead_m, double steering_rad) {
  return paths.distance_sum(T_map_vehicle *
                            drive(vehicle, {sign(paths.gear()) * look_ahead_m, steering_rad}));
}

/// How much L_P can change at most for each radian of steering. The front reference point after the distance
/// S is the integral of unit(delta + s sin(delta) / d) over s = 0 .. S, which changes by at most 1 + s / d;
/// base_link that of cos(delta) unit(s sin(delta) / d), by at most |sin(delta)| + s / d.
double cost_slope_m_per_rad(const FrontSteered& vehicle, double look_ahead_m, double steering_max_rad) {
  const double by_turn_m = look_ahead_m * look_ahead_m / (2 * std::abs(vehicle.wheelbase_m));
  return look_ahead_m * (1 + std::sin(steering_max_rad)) + 2 * by_turn_m;
}

/// A differential vehicle steers as if it had front wheels two look-aheads ahead, or behind when it drives
/// backwards: it then converges to its path without oscillating.
FrontSteered steered_like_differential(double look_ahead_m, bool in_reverse) {
  return {(in_reverse ? -2 : 2) * look_ahead_m};
}

/// The steering angle at which a differential vehicle turns as fast as it can.
double steering_max_rad(const DriveLimits& limits, const FrontSteered& steered, double speed_mps) {
  constexpr double kMost_rad = 80 * kDegree;
  if (speed_mps <= 0) return kMost_rad;
  return std::min(kMost_rad,
                  std::atan(limits.turn_rate_max_rad_s / speed_mps * std::abs(steered.wheelbase_m)));
}

/// The angles that the wheels can reach by the next cycle.
Interval reachable(const VehicleDescription& vehicle, double steering_rad) {
  const double max_rad = vehicle.limits.steering_max_rad;
  const double now_rad = std::clamp(steering_rad, -max_rad, max_rad);
  const double change_rad = vehicle.limits.steering_rate_max_rad_s * vehicle.cycle_s;
  return {std::max(now_rad - change_rad, -max_rad), std::min(now_rad + change_rad, max_rad)};
}

}  // namespace

void SteeringParams::describe(FieldList& fields) {
  fields.real("look_ahead_m", look_ahead_m, {0.02, 10}, "distance over which a steering angle is judged");
  fields.real("look_ahead_s", look_ahead_s, {0, 10}, "added to it for each m/s of speed");
  fields.real("bend_ahead_m", bend_ahead_m, {0, 1}, "reversing: how far before a bend the wheels turn");
  fields.real("bend_ahead_s", bend_ahead_s, {0, 2}, "added to it for each m/s of speed");
  fields.angle("angle_step_deg", angle_step_rad, {0.01, 5}, "steering angles are multiples of this");
}

double steering_cost(const FrontSteered& vehicle, const Path& path, const PathPoint& from,
                     const Pose2& T_map_vehicle, double look_ahead_m, double steering_rad) {
  const WheelPaths paths(vehicle, path, from, reach_m(vehicle, look_ahead_m));
  return cost(paths, vehicle, T_map_vehicle, look_ahead_m, steering_rad);
}

PathFollower::PathFollower(const VehicleDescription& vehicle, const SteeringParams& params)
    : vehicle_(vehicle), params_(params) {}

Command PathFollower::follow(const Path& path, const PathPoint& from, const Pose2& T_map_vehicle,
                             double speed_mps, double steering_rad) const {
  const PathPiece& piece = path.pieces()[from.piece];
  if (piece.is_on_the_spot()) return turn_to(piece.end().theta, T_map_vehicle.theta);
  const bool in_reverse = piece.arc.length_m < 0;
  const double along_mps = in_reverse ? -speed_mps : speed_mps;
  const double ahead_m = params_.look_ahead_m + params_.look_ahead_s * speed_mps;
  if (vehicle_.is_differential) {
    const FrontSteered steered = steered_like_differential(ahead_m, in_reverse);
    const double most_rad = steering_max_rad(vehicle_.limits, steered, speed_mps);
    const double best_rad =
        best_steering_rad(steered, path, from, T_map_vehicle, ahead_m, {-most_rad, most_rad});
    return {.speed_mps = along_mps, .turn_rate_rad_s = along_mps * std::tan(best_rad) / steered.wheelbase_m};
  }
  const double bend_ahead_m = params_.bend_ahead_m + params_.bend_ahead_s * speed_mps;
  const double wheels_rad =
      in_reverse ? reversing_steering_rad(vehicle_, path, from, T_map_vehicle, bend_ahead_m, steering_rad)
                 : best_steering_rad(vehicle_.front_steered, path, from, T_map_vehicle, ahead_m,
                                     reachable(vehicle_, steering_rad));
  return {.speed_mps = along_mps, .steering_rad = wheels_rad};
}

double PathFollower::best_steering_rad(const FrontSteered& steered, const Path& path, const PathPoint& from,
                                       const Pose2& T_map_vehicle, double look_ahead_m,
                                       const Interval& allowed_rad) const {
  constexpr double kRounding = 1e-9;
  const double step_rad = params_.angle_step_rad;
  const int min = static_cast<int>(std::ceil(allowed_rad.min / step_rad - kRounding));
  const int max = std::max(min, static_cast<int>(std::floor(allowed_rad.max / step_rad + kRounding)));
  const double most_rad = std::max(-allowed_rad.min, allowed_rad.max);
  const double slope_m = step_rad * cost_slope_m_per_rad(steered, look_ahead_m, most_rad);
  const WheelPaths paths(steered, path, from, reach_m(steered, look_ahead_m));
  const GridValue best = least_on_grid(min, max, slope_m, [&](int i) {
    return cost(paths, steered, T_map_vehicle, look_ahead_m, i * step_rad);
  });
  return best.index * step_rad;
}

/// A quarter of the remaining turn in each cycle: with a command that acts a cycle late, this is the fastest
/// way to stop without overshoot.
Command PathFollower::turn_to(double due_rad, double heading_rad) const {
  const double left_rad = wrap_angle(due_rad - heading_rad);
  const double rate_max_rad_s = vehicle_.limits.turn_rate_max_rad_s;
  return {.turn_rate_rad_s = std::clamp(left_rad / (4 * vehicle_.cycle_s), -rate_max_rad_s, rate_max_rad_s)};
}

}  // namespace aisle
