#include "aisle/guidance/obstacles/floor_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

constexpr double kObeyed_s = 0.25;  // from a command to its effect
constexpr double kCheckRulesEvery_m = 0.05;
constexpr double kAgainst_rad = 120 * kDegree;  // off a one-way zone's direction; paths keep within less

/// What the vehicle drives if it executes a command and then brakes.
struct StoppingPath {
  /// The vehicle's motion over its first `step` of `steps`.
  Pose2 T_vehicle_later(int step) const {
    const double share = static_cast<double>(step) / steps;
    if (vehicle.is_differential)
      return end_pose({share * path_m, share * command.turn_rate_rad_s * kObeyed_s});
    return drive(vehicle.front_steered, FrontSteeredMotion{share * path_m, command.steering_rad});
  }

  const VehicleDescription& vehicle;
  Command command;
  double path_m;
  int steps;
};

StoppingPath stopping_path(const VehicleDescription& vehicle, const Command& command) {
  const double speed = command.speed_mps;
  const double path_m =
      speed * kObeyed_s + speed * std::abs(speed) / (2 * vehicle.limits.deceleration_max_mps2);
  const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(path_m) / kCheckRulesEvery_m)));
  return {vehicle, command, path_m, steps};
}

}  // namespace

FloorRules::FloorRules(const Building& building, const VehicleDescription& vehicle)
    : lines_(lines_not_crossed(building)), zones_(building.zones), vehicle_(vehicle) {}

/// Empty: it is not.
std::string FloorRules::why_forbidden(const Pose2& T_map_vehicle, double speed_mps) const {
  if (const Zone* zone = keep_out_around(zones_, T_map_vehicle.position()))
    return fmt::format("is in the {}", words_for(*zone));
  if (const Barrier* line = barrier_met(lines_, vehicle_.footprint, T_map_vehicle))
    return fmt::format("{} ahead", words_for(line->kind));
  if (speed_mps == 0) return "";
  const Zone* against = one_way_against(zones_, T_map_vehicle, gear_of(speed_mps), kAgainst_rad);
  return against == nullptr ? "" : fmt::format("would drive against the {}", words_for(*against));
}

Decision FloorRules::obey(Decision decision, const Pose2& T_map_vehicle) const {
  if (empty() || decision.status != NavigatorStatus::kGoing || decision.command == Command{}) return decision;
  const StoppingPath stopping = stopping_path(vehicle_, decision.command);
  for (int step = 0; step <= stopping.steps; ++step) {
    std::string why =
        why_forbidden(T_map_vehicle * stopping.T_vehicle_later(step), decision.command.speed_mps);
    if (!why.empty()) return {.status = NavigatorStatus::kFailed, .state = "blocked", .why = std::move(why)};
  }
  decision.command = slowed(decision.command, T_map_vehicle);
  return decision;
}

Command FloorRules::slowed(Command command, const Pose2& T_map_vehicle) const {
  if (zones_.empty() || command.speed_mps == 0) return command;
  const StoppingPath stopping = stopping_path(vehicle_, command);
  double share = 1;
  for (int step = 0; step <= stopping.steps; ++step) {
    const Pose2 T_map_later = T_map_vehicle * stopping.T_vehicle_later(step);
    share =
        std::min(share, speed_max_mps(zones_, vehicle_.footprint, T_map_later) / std::abs(command.speed_mps));
  }
  command.speed_mps *= share;
  command.turn_rate_rad_s *= share;
  return command;
}

}  // namespace aisle
