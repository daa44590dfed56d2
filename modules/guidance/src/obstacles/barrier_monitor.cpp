#include "aisle/guidance/obstacles/barrier_monitor.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {
namespace {

constexpr double kObeyed_s = 0.25;  // from a command to its effect
constexpr double kBarrierCheckEvery_m = 0.05;

/// The vehicle's motion over a part of its stopping path.
Pose2 pose_after(const VehicleDescription& vehicle, const Command& command, double path_m, double turn_rad) {
  if (vehicle.is_differential) return end_pose({path_m, turn_rad});
  return drive(vehicle.front_steered, FrontSteeredMotion{path_m, command.steering_rad});
}

}  // namespace

const Barrier* barrier_ahead(std::span<const Barrier> barriers, const VehicleDescription& vehicle,
                             const Pose2& T_map_vehicle, const Command& command) {
  if (barriers.empty() || command == Command{}) return nullptr;
  const double speed = command.speed_mps;
  const double path_m =
      speed * kObeyed_s + speed * std::abs(speed) / (2 * vehicle.limits.deceleration_max_mps2);
  const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(path_m) / kBarrierCheckEvery_m)));
  for (int i = 0; i <= steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    const Pose2 T_vehicle_later =
        pose_after(vehicle, command, share * path_m, share * command.turn_rate_rad_s * kObeyed_s);
    if (const Barrier* met = barrier_met(barriers, vehicle.footprint, T_map_vehicle * T_vehicle_later))
      return met;
  }
  return nullptr;
}

}  // namespace aisle
