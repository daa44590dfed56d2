#pragma once
/// How well a mission through a room ended. No navigator ever sees any of this.

#include <nlohmann/json.hpp>
#include <optional>

#include "aisle/maps/room_route.hpp"
#include "aisle/missions/rooms/room_mission.hpp"
#include "aisle/simulation/world.hpp"

namespace aisle {

struct RoomErrors {
  double end_m = 0;  ///< true distance from the due end pose
  double end_rad = 0;
  Vec2 p_due_end = Vec2::Zero();  ///< true end position in the frame of the due pose: ahead, left
  double clearance_m = 0;         ///< free distance straight ahead of the vehicle at the end
};

/// A mission and, where the truth is known, its errors.
struct JudgedRoomMission {
  RoomMissionResult mission;
  std::optional<RoomErrors> errors;
};

/// @param T_world_due  due end pose
JudgedRoomMission judged(RoomMissionResult mission, const World& world, const Footprint& footprint,
                         const Pose2& T_world_due);

/// Due end pose of a route in the world: in the nearest parking frame, or where it was taught.
/// @param in_reverse  turned by 180 degrees in the frame
Pose2 due_end(const World& world, const Footprint& footprint, ParkingStrategy parking,
              const Pose2& T_world_taught_end, bool in_reverse);

/// The figures of a mission as `navigate` and `park` print them.
nlohmann::ordered_json figures_of(const JudgedRoomMission& judged);

}  // namespace aisle
