#include "aisle/guidance/rooms/free_steering.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "aisle/core/square.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {
namespace {

constexpr double kPathStep_m = 0.1;

struct Obstacle {
  Vec2 p_vehicle;
  double from_m;  ///< distance from base_link
};

std::vector<Obstacle> nearest_first(std::span<const Vec2> p_vehicle) {
  std::vector<Obstacle> obstacles;
  obstacles.reserve(p_vehicle.size());
  for (const Vec2& p : p_vehicle) obstacles.push_back({p, p.norm()});
  std::sort(obstacles.begin(), obstacles.end(),
            [](const Obstacle& a, const Obstacle& b) { return a.from_m < b.from_m; });
  return obstacles;
}

/// From the footprint, after some path, to the obstacle nearest to it there.
double nearest_m(const Footprint& footprint, std::span<const Obstacle> obstacles, const Pose2& T_now_then,
                 double path_m) {
  constexpr double kFar_m = 10;
  const double radius_m = std::hypot(std::max(footprint.front_m, footprint.rear_m), footprint.width_m / 2);
  const Pose2 T_then_now = T_now_then.inverse();
  const double c = std::cos(T_then_now.theta), s = std::sin(T_then_now.theta);
  double least_m = kFar_m;
  for (const auto& [p, from_m] : obstacles) {
    if (from_m - path_m - radius_m >= least_m) break;  // all others are farther away
    const Vec2 p_then(c * p.x() - s * p.y() + T_then_now.x, s * p.x() + c * p.y() + T_then_now.y);
    least_m = std::min(least_m, off_footprint_m(footprint, p_then));
  }
  return least_m;
}

SteeringChoice free_path_among(const VehicleDescription& vehicle, const FreeSteeringParams& params,
                               std::span<const Obstacle> obstacles, double steering_rad, Gear gear) {
  const double turn_per_m = std::tan(steering_rad) / vehicle.front_steered.wheelbase_m;
  const double now_m = nearest_m(vehicle.footprint, obstacles, {}, 0);
  SteeringChoice choice{.steering_rad = steering_rad, .free_m = 0, .clearance_m = now_m};
  const int steps = static_cast<int>(std::lround(params.reach_m / kPathStep_m));
  for (int step = 1; step <= steps; ++step) {
    const double path_m = step * kPathStep_m;
    const Pose2 T_now_then = end_pose({sign(gear) * path_m, sign(gear) * path_m * turn_per_m});
    const double off_m = nearest_m(vehicle.footprint, obstacles, T_now_then, path_m);
    // The vehicle may drive away from an obstacle that is too near already.
    if (off_m < std::min(params.margin_m, now_m - 0.001)) break;
    choice.free_m = path_m;
    choice.clearance_m = std::min(choice.clearance_m, off_m);
  }
  return choice;
}

}  // namespace

void FreeSteeringParams::describe(FieldList& fields) {
  fields.real("reach_m", reach_m, {0.2, 10}, "path over which a steering angle is judged");
  fields.real("margin_m", margin_m, {0, 1}, "the vehicle keeps at least this clearance");
  fields.real("comfort_m", comfort_m, {0.01, 2}, "the vehicle tries to keep this clearance");
  fields.angle("step_deg", step_rad, {0.5, 20}, "between the steering angles that are tried");
  fields.angle("requested_deg", requested_rad, {1, 90}, "difference from the requested angle that costs 1");
  fields.real("clearance_weight", clearance_weight, {0, 100}, "cost of no clearance");
  fields.real("reach_weight", reach_weight, {0, 100}, "cost of no free path");
}

SteeringChoice free_path(const VehicleDescription& vehicle, const FreeSteeringParams& params,
                         std::span<const Vec2> p_vehicle, double steering_rad, Gear gear) {
  return free_path_among(vehicle, params, nearest_first(p_vehicle), steering_rad, gear);
}

SteeringChoice choose_steering(const VehicleDescription& vehicle, const FreeSteeringParams& params,
                               std::span<const Vec2> p_vehicle, double requested_rad, Gear gear) {
  const std::vector<Obstacle> obstacles = nearest_first(p_vehicle);
  const double max_rad = vehicle.limits.steering_max_rad;
  const double clamped_rad = std::clamp(requested_rad, -max_rad, max_rad);
  const int steps = static_cast<int>(2 * max_rad / params.step_rad);
  SteeringChoice best;
  double least = 0;
  for (int i = -1; i <= steps; ++i) {
    const double steering_rad = i < 0 ? clamped_rad : std::min(-max_rad + i * params.step_rad, max_rad);
    const SteeringChoice choice = free_path_among(vehicle, params, obstacles, steering_rad, gear);
    const double cost =
        square((steering_rad - clamped_rad) / params.requested_rad) +
        params.clearance_weight * square(std::clamp(1 - choice.clearance_m / params.comfort_m, 0.0, 1.0)) +
        params.reach_weight * square(1 - choice.free_m / params.reach_m);
    if (i >= 0 && cost >= least) continue;
    least = cost;
    best = choice;
  }
  return best;
}

}  // namespace aisle
