#pragma once
/// Trips of a simulated cart that knows where it is and follows a line, with nothing but the guard between it
/// and what is in the way.

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "aisle/formats/vehicle_yaml.hpp"
#include "aisle/formats/world_yaml.hpp"
#include "aisle/guidance/obstacle_guard.hpp"
#include "aisle/simulation/simulated_vehicle.hpp"

namespace aisle {

/// Pure pursuit of a polyline by base_link.
class LineFollower {
 public:
  explicit LineFollower(std::vector<Vec2> line) : line_(std::move(line)) {}

  bool has_arrived(const Pose2& T_world_vehicle) const {
    return (T_world_vehicle.position() - line_.back()).norm() < 0.5 && next_ + 1 == line_.size();
  }

  Command follow(const Pose2& T_world_vehicle, double speed_mps, double wheelbase_m) {
    const Vec2 target = T_world_vehicle.inverse() * aim(T_world_vehicle.position());
    const double turn_rad_per_m = 2 * target.y() / target.squaredNorm();
    const double steering_rad = target.x() < 0
                                    ? std::copysign(0.7, target.y())
                                    : std::clamp(std::atan(wheelbase_m * turn_rad_per_m), -0.7, 0.7);
    return {.speed_mps = speed_mps * (1 - 0.6 * std::abs(steering_rad) / 0.7), .steering_rad = steering_rad};
  }

 private:
  /// The point of the line a look-ahead before the vehicle.
  Vec2 aim(const Vec2& p_world) {
    constexpr double kLookAhead_m = 0.8;
    while (next_ + 1 < line_.size() && foot(next_, p_world).second >= 1) ++next_;
    Vec2 at = foot(next_, p_world).first;
    double left_m = kLookAhead_m;
    for (std::size_t i = next_; i < line_.size(); ++i) {
      const double way_m = (line_[i] - at).norm();
      if (way_m >= left_m) return at + left_m / way_m * (line_[i] - at);
      left_m -= way_m;
      at = line_[i];
    }
    const Vec2 along = (line_.back() - line_[line_.size() - 2]).normalized();
    return at + left_m * along;
  }

  /// The nearest point of the line before a way point, and its share of the way.
  std::pair<Vec2, double> foot(std::size_t to, const Vec2& p) const {
    const Vec2 along = line_[to] - line_[to - 1];
    const double share = std::clamp((p - line_[to - 1]).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return {line_[to - 1] + share * along, share};
  }

  std::vector<Vec2> line_;
  std::size_t next_ = 1;
};

struct GuardedTrip {
  struct Stop {
    double stamp_s = 0;
    Pose2 T_world_vehicle;
    std::string why;
  };
  double way_m = 0;
  double duration_s = 0;
  std::size_t collisions = 0;
  bool arrived = false;
  std::vector<Stop> stops;  ///< each time that it began to wait
  Guarded last;
};

/// The cart with its corridor camera alone.
inline VehicleModel corridor_cart(double speed_max_mps = 0.5) {
  auto model = read_vehicle(AISLE_SOURCE_DIR "/vehicles/alv.yaml");
  if (!model) throw std::runtime_error(to_string(model.problems()));
  std::erase_if(model->description.cameras, [](const auto& camera) { return camera.name != "corridor"; });
  model->description.laser_markers.reset();
  model->description.limits.speed_max_mps = speed_max_mps;
  return *model;
}

struct GuardedTripOptions {
  double speed_mps = 0.3;
  std::uint64_t seed = 1;
  double time_max_s = 300;
  std::function<void(const Observation&, const Guarded&, const ObstacleGuard&, const SimulatedVehicle&)>
      on_cycle = {};
};

inline GuardedTrip guarded_trip(const World& world, const VehicleModel& model, const Scenario& scenario,
                                const std::vector<Vec2>& line, const GuardedTripOptions& options) {
  const Vec2 along = line[1] - line[0];
  SimulatedVehicle vehicle(
      world, model, scenario,
      {.seed = options.seed, .T_world_start = {line[0].x(), line[0].y(), std::atan2(along.y(), along.x())}});
  ObstacleGuard guard(model.description, {});
  LineFollower follower(line);
  GuardedTrip trip;
  GuardState before = GuardState::kWaiting;  // for the first picture
  while (vehicle.truth().stamp_s < options.time_max_s && !trip.arrived) {
    const auto observation = vehicle.sense();
    const SimulatedTruth& truth = vehicle.truth();
    const Command wish = follower.follow(truth.T_world_vehicle, options.speed_mps,
                                         model.description.front_steered.wheelbase_m);
    trip.last = guard.guard(*observation, wish);
    vehicle.act(trip.last.command);
    if (trip.last.state != GuardState::kFree && before == GuardState::kFree) {
      trip.stops.push_back({truth.stamp_s, truth.T_world_vehicle, trip.last.why});
    }
    before = trip.last.state;
    if (options.on_cycle) options.on_cycle(*observation, trip.last, guard, vehicle);
    trip.arrived = follower.has_arrived(truth.T_world_vehicle);
  }
  trip.way_m = vehicle.truth().way_m;
  trip.duration_s = vehicle.truth().stamp_s;
  trip.collisions = vehicle.truth().collisions;
  return trip;
}

}  // namespace aisle
