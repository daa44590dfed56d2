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

/// What a simulated mission through a room came to.
struct RoomMissionResult {
  MissionEnd end;
  std::size_t collisions = 0;
  double distance_m = 0;
  double end_error_m = 0;  ///< from where the vehicle was to park, by the truth
  double end_error_rad = 0;
  Vec2 p_due_end = Vec2::Zero();  ///< where it stands, seen from where it was to: ahead, left
  double clearance_m = 0;         ///< at the end, straight ahead of the vehicle
  int tries = 1;
  bool is_confirmed = false;            ///< that it is the place, by what is there
  std::optional<bool> has_seen_corner;  ///< of the route, where it backed between turnings
  std::vector<double> cycle_s;          ///< processor time of each cycle, from image to command

  bool parked() const { return end.arrived && collisions == 0; }
};

struct RoomMissionOptions {
  std::uint64_t seed = 1;
  Pose2 T_world_start;  ///< where the vehicle is set down
  Pose2 T_world_due;    ///< where it is to park
};

Result<RoomMissionResult> drive_room_mission(const SimulationSetting& setting, RoomNavigator& navigator,
                                             const RoomMissionOptions& options,
                                             std::optional<SessionRecord>& session, Progress& progress);

/// Where a route's end is due: in the world's parking frame next to it, or where it was taught.
/// @param in_reverse  in the frame, turned about
Pose2 due_end(const World& world, const Footprint& footprint, ParkingStrategy parking,
              const Pose2& T_world_taught_end, bool in_reverse);

/// The figures of a mission as `navigate` and `park` print them.
nlohmann::ordered_json figures_of(const RoomMissionResult& result);

}  // namespace aisle
