#include "rooms/room_mission.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "aisle/guidance/rooms/room_cameras.hpp"
#include "aisle/simulation/cross_section.hpp"
#include "aisle/simulation/vehicle/simulated_vehicle.hpp"
#include "rounded.hpp"
#include "simulated_record.hpp"
#include "statistics.hpp"
#include "timed_navigator.hpp"

namespace aisle {
namespace {

/// Free distance straight ahead of the vehicle; at most `kFar_m`.
double clearance_ahead_m(const World& world, const Footprint& footprint, const Pose2& T_world_vehicle) {
  constexpr double kFar_m = 5, kStep_m = 0.01;
  for (int step = 1; step * kStep_m < kFar_m; ++step) {
    if (!fits(world, footprint, T_world_vehicle * Pose2{step * kStep_m, 0, 0})) return (step - 1) * kStep_m;
  }
  return kFar_m;
}

/// Records the mission's session, and shows what the navigator sees.
class RoomMissionRecord final : public SimulatedRecord {
 public:
  RoomMissionRecord(std::optional<SessionRecord>& session, const SimulatedVehicle& vehicle,
                    const RoomNavigator& navigator)
      : SimulatedRecord(session, vehicle), navigator_(navigator) {}

  using SimulatedRecord::keep;

  Problems keep(const Decision& decision) override {
    show_pose({navigator_.pose()});
    if (is_watched() && image_camera() == kFirstCamera && navigator_.sight())
      show_overlay(overlay_of(navigator_.view(), *navigator_.sight()));
    return SimulatedRecord::keep(decision);
  }

 private:
  const RoomNavigator& navigator_;
};

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

Result<RoomMissionResult> drive_room_mission(const SimulationSetting& setting, RoomNavigator& navigator,
                                             const RoomMissionOptions& options,
                                             std::optional<SessionRecord>& session, Progress& progress) {
  SimulatedVehicle vehicle(setting.world, setting.vehicle, setting.scenario,
                           {.seed = options.seed, .T_world_start = options.T_world_start});
  RoomMissionResult result;
  TimedNavigator timed(navigator, result.cycle_s);
  RoomMissionRecord record(session, vehicle, navigator);
  auto end = run_mission(vehicle, timed, record, progress);
  if (!end) return end.problems();
  // The vehicle coasts to a standstill.
  constexpr int kUntilItStands = 20;
  for (int i = 0; i < kUntilItStands && vehicle.truth().speed_mps != 0; ++i) vehicle.sense();
  result.end = std::move(*end);
  const SimulatedTruth& truth = vehicle.truth();
  result.collisions = truth.collisions;
  result.distance_m = truth.path_m;
  const Pose2 off = between(options.T_world_due, truth.T_world_vehicle);
  result.end_error_m = off.position().norm();
  result.end_error_rad = std::abs(off.theta);
  result.p_due_end = off.position();
  result.clearance_m =
      clearance_ahead_m(setting.world, setting.vehicle.description.footprint, truth.T_world_vehicle);
  result.tries = navigator.parking_tries();
  result.has_seen_corner = navigator.has_seen_corner();
  result.is_confirmed = result.end.arrived && navigator.has_confirmed_place();
  return result;
}

nlohmann::ordered_json figures_of(const RoomMissionResult& result) {
  nlohmann::ordered_json figures = {{"arrived", result.end.arrived},
                                    {"parked", result.parked()},
                                    {"confirmed", result.is_confirmed},
                                    {"state", result.end.state},
                                    {"why", result.end.why},
                                    {"collisions", result.collisions},
                                    {"end_error_m", rounded(result.end_error_m, 4)},
                                    {"end_ahead_m", rounded(result.p_due_end.x(), 4)},
                                    {"end_left_m", rounded(result.p_due_end.y(), 4)},
                                    {"end_error_deg", rounded(to_degrees(result.end_error_rad), 3)},
                                    {"tries", result.tries},
                                    {"clearance_m", rounded(result.clearance_m, 3)},
                                    {"distance_m", rounded(result.distance_m, 3)},
                                    {"duration_s", rounded(result.end.duration_s, 3)},
                                    {"cycle_ms", cycle_figures(result.cycle_s)}};
  if (result.has_seen_corner) figures["corner_seen"] = *result.has_seen_corner;
  return figures;
}

}  // namespace aisle
