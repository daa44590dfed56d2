#include "aisle/evaluation/rooms/room_evaluation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "aisle/core/rounded.hpp"
#include "aisle/missions/statistics.hpp"
#include "aisle/simulation/vehicle/simulated_vehicle.hpp"

namespace aisle {
namespace {

/// Free distance straight ahead of the vehicle; at most `kFar_m`.
double clearance_ahead_m(const World& world, const Footprint& footprint, const Pose2& T_world_vehicle) {
  constexpr double kFar_m = 5, kAheadStep_m = 0.01;
  for (int step = 1; step * kAheadStep_m < kFar_m; ++step) {
    if (!fits(world, footprint, T_world_vehicle * Pose2{step * kAheadStep_m, 0, 0}))
      return (step - 1) * kAheadStep_m;
  }
  return kFar_m;
}

/// null: none.
nlohmann::ordered_json odometry_figures(const std::optional<OdometryCorrection>& error) {
  if (!error) return {};
  return {{"distance_factor", rounded(error->distance_factor, 3)},
          {"steering_bias_deg", rounded(to_degrees(error->steering_bias_rad), 2)}};
}

}  // namespace

Pose2 due_end(const World& world, const Footprint& footprint, ParkingStrategy parking,
              const Pose2& T_world_taught_end, bool in_reverse) {
  if (parking != ParkingStrategy::kFrame || world.parking_frames.empty()) return T_world_taught_end;
  const auto off_m = [&](const ParkingFrame& frame) {
    return (frame.centre - T_world_taught_end.position()).norm();
  };
  const auto frame = std::min_element(world.parking_frames.begin(), world.parking_frames.end(),
                                      [&](const auto& a, const auto& b) { return off_m(a) < off_m(b); });
  const double heading_rad = frame->heading_rad + (in_reverse ? kPi : 0);
  return Pose2{frame->centre.x(), frame->centre.y(), wrap_angle(heading_rad)} *
         Pose2{(footprint.rear_m - footprint.front_m) / 2, 0, 0};
}

JudgedRoomMission judged(RoomMissionResult mission, const World& world, const Footprint& footprint,
                         const Pose2& T_world_due) {
  if (!mission.is_simulated()) return {std::move(mission), std::nullopt};
  const Pose2& T_world_end = mission.truth->T_world_vehicle;
  const Pose2 off = between(T_world_due, T_world_end);
  const RoomErrors errors{.end_m = off.position().norm(),
                          .end_rad = std::abs(off.theta),
                          .p_due_end = off.position(),
                          .clearance_m = clearance_ahead_m(world, footprint, T_world_end)};
  return {std::move(mission), errors};
}

nlohmann::ordered_json figures_of(const JudgedRoomMission& judged) {
  const RoomMissionResult& mission = judged.mission;
  const auto error = [&](const auto& figure_of) {
    return judged.errors ? nlohmann::ordered_json(figure_of(*judged.errors)) : nlohmann::ordered_json();
  };
  return known_figures(
      {{"arrived", mission.end.arrived},
       {"parked", mission.parked()},
       {"confirmed", mission.is_confirmed},
       {"state", mission.end.state},
       {"why", mission.end.why},
       {"collisions", if_known(mission.collisions())},
       {"end_error_m", error([](const RoomErrors& e) { return rounded(e.end_m, 4); })},
       {"end_ahead_m", error([](const RoomErrors& e) { return rounded(e.p_due_end.x(), 4); })},
       {"end_left_m", error([](const RoomErrors& e) { return rounded(e.p_due_end.y(), 4); })},
       {"end_error_deg", error([](const RoomErrors& e) { return rounded(to_degrees(e.end_rad), 3); })},
       {"tries", mission.tries},
       {"clearance_m", error([](const RoomErrors& e) { return rounded(e.clearance_m, 3); })},
       {"distance_m", rounded(mission.distance_m(), 3)},
       {"duration_s", rounded(mission.end.duration_s, 3)},
       {"cycle_ms", cycle_figures(mission.cycle_s)},
       {"corner_seen", if_known(mission.has_seen_corner)},
       {"odometry_error", odometry_figures(mission.odometry_correction)}});
}

}  // namespace aisle
