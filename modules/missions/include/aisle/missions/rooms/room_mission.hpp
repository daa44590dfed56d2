#pragma once

#include <optional>

#include "aisle/core/progress.hpp"
#include "aisle/core/result.hpp"
#include "aisle/formats/sessions/session_record.hpp"
#include "aisle/guidance/rooms/room_navigator.hpp"
#include "aisle/missions/mission_result.hpp"

namespace aisle {

/// Result of a mission through a room. The truth is that of the vehicle at a standstill.
struct RoomMissionResult : MissionResult {
  int tries = 1;
  bool is_confirmed = false;            ///< whether the place was confirmed by what is seen there
  std::optional<bool> has_seen_corner;  ///< the route's corner; set if it backed up between turnings
  std::optional<OdometryCorrection> odometry_correction;  ///< at the end; set if the vehicle corrected one

  bool parked() const { return end.arrived && is_unharmed(); }
};

/// @param truth  of the vehicle; null: unknown
Result<RoomMissionResult> drive_room_mission(Vehicle& vehicle, const TruthSource* truth,
                                             RoomNavigator& navigator, std::optional<SessionRecord>& session,
                                             Progress& progress);

}  // namespace aisle
