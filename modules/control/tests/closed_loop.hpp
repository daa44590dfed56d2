#pragma once
/// A vehicle that follows a path, with what makes that hard: a cycle between sensing and acting, and steering
/// and motors that need time.

#include <algorithm>
#include <cmath>
#include <vector>

#include "aisle/control/path_progress.hpp"
#include "aisle/control/speed.hpp"
#include "aisle/control/steering.hpp"

namespace aisle {

/// The vehicles of vehicles/alv.yaml and vehicles/mini.yaml, as far as driving goes. The first may drive 1
/// m/s.
inline VehicleDescription cart() {
  VehicleDescription vehicle;
  vehicle.front_steered = {0.75};
  vehicle.limits = {.speed_max_mps = 1.0, .reverse_speed_max_mps = 0.5};
  return vehicle;
}

inline VehicleDescription mini_vehicle() {
  VehicleDescription vehicle;
  vehicle.is_differential = true;
  vehicle.limits = {.speed_max_mps = 0.2,
                    .reverse_speed_max_mps = 0.1,
                    .turn_rate_max_rad_s = 45 * kDegree,
                    .turn_acceleration_max_rad_s2 = 180 * kDegree};
  return vehicle;
}

/// Lines and arcs one after the other from the origin.
inline Path path_of(const std::vector<Arc>& arcs, Pose2 T_map_start = {}) {
  std::vector<PathPiece> pieces;
  for (const Arc& arc : arcs) {
    pieces.push_back({T_map_start, arc});
    T_map_start = pieces.back().end();
  }
  return Path(pieces);
}

struct DrivenCycle {
  double along_m = 0;
  double lateral_m = 0;
  double heading_off_rad = 0;
  double speed_mps = 0;
};

struct ClosedLoop {
  VehicleDescription vehicle;
  SteeringParams steering;
  SpeedParams speed;
  double steering_bias_rad = 0;  ///< the wheels really point this much farther left
  Pose2 T_map_vehicle;
  double time_max_s = 600;

  bool arrived = false;
  std::vector<DrivenCycle> cycles;

  void drive_along(const Path& path) {
    const PathFollower follower(vehicle, steering);
    PathProgress progress(path);
    Command acting, state;
    for (double time_s = 0; time_s < time_max_s; time_s += vehicle.cycle_s) {
      const PathPoint& at = progress.advance(T_map_vehicle);
      const double off_rad = wrap_angle(T_map_vehicle.theta - at.T_map_path.theta);
      cycles.push_back({at.along_m, at.lateral_m, off_rad, state.speed_mps});
      arrived = progress.has_arrived();
      if (arrived) return;
      const double speed_mps = speed_along(path, at.along_m, 1, vehicle, speed);
      const Command next = follower.follow(path, at, T_map_vehicle, speed_mps, state.steering_rad);
      move(acting, state);
      acting = next;
    }
  }

  void move(const Command& wanted, Command& state) {
    const DriveLimits& limits = vehicle.limits;
    const auto approach = [](double& value, double goal, double change) {
      value += std::clamp(goal - value, -change, change);
    };
    constexpr int kParts = 20;
    const double part_s = vehicle.cycle_s / kParts;
    for (int i = 0; i < kParts; ++i) {
      approach(state.speed_mps, wanted.speed_mps, limits.acceleration_max_mps2 * part_s);
      approach(state.steering_rad,
               std::clamp(wanted.steering_rad, -limits.steering_max_rad, limits.steering_max_rad),
               limits.steering_rate_max_rad_s * part_s);
      approach(state.turn_rate_rad_s, wanted.turn_rate_rad_s, limits.turn_acceleration_max_rad_s2 * part_s);
      const double path_m = state.speed_mps * part_s;
      T_map_vehicle = T_map_vehicle *
                      (vehicle.is_differential
                           ? end_pose({path_m, state.turn_rate_rad_s * part_s})
                           : drive(vehicle.front_steered, {path_m, state.steering_rad + steering_bias_rad}));
    }
  }

  double lateral_max_m(double from_m = 0, double to_m = 1e9) const {
    double max_m = 0;
    for (const DrivenCycle& cycle : cycles) {
      if (cycle.along_m >= from_m && cycle.along_m <= to_m)
        max_m = std::max(max_m, std::abs(cycle.lateral_m));
    }
    return max_m;
  }
};

}  // namespace aisle
