#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "aisle/core/progress.hpp"
#include "aisle/core/result.hpp"
#include "aisle/formats/sessions/session_record.hpp"
#include "aisle/guidance/mission.hpp"
#include "aisle/guidance/rooms/room_navigator.hpp"
#include "simulation_setting.hpp"

namespace aisle {

/// Result of a simulated mission through a room.
struct RoomMissionResult {
  MissionEnd end;
  std::size_t collisions = 0;
  double distance_m = 0;
  double end_error_m = 0;  ///< true distance from the due end pose
  double end_error_rad = 0;
  Vec2 p_due_end = Vec2::Zero();  ///< true end position in the frame of the due pose: ahead, left
  double clearance_m = 0;         ///< free distance straight ahead of the vehicle at the end
  int tries = 1;
  bool is_confirmed = false;            ///< whether the place was confirmed by what is seen there
  std::optional<bool> has_seen_corner;  ///< the route's corner; set if it backed up between turnings
  std::vector<double> cycle_s;          ///< processor time of each cycle, from image to command

  bool parked() const { return end.arrived && collisions == 0; }
};

struct RoomMissionOptions {
  std::uint64_t seed = 1;
  Pose2 T_world_start;  ///< initial pose of the vehicle
  Pose2 T_world_due;    ///< due end pose
};

Result<RoomMissionResult> drive_room_mission(const SimulationSetting& setting, RoomNavigator& navigator,
                                             const RoomMissionOptions& options,
                                             std::optional<SessionRecord>& session, Progress& progress);

/// Due end pose of a route in the world: in the nearest parking frame, or where it was taught.
/// @param in_reverse  turned by 180 degrees in the frame
Pose2 due_end(const World& world, const Footprint& footprint, ParkingStrategy parking,
              const Pose2& T_world_taught_end, bool in_reverse);

/// The figures of a mission as `navigate` and `park` print them.
nlohmann::ordered_json figures_of(const RoomMissionResult& result);

}  // namespace aisle
