#pragma once

#include <optional>
#include <string>
#include <vector>

#include "aisle/core/progress.hpp"
#include "aisle/core/result.hpp"
#include "aisle/formats/sessions/session_record.hpp"
#include "aisle/guidance/landmarks/landmark_navigator.hpp"
#include "aisle/learning/landmarks/landmark_learning.hpp"
#include "aisle/missions/landmarks/landmark_driver.hpp"
#include "aisle/missions/mission_result.hpp"

namespace aisle {

/// Result of a mission along a learned route.
struct LandmarkMissionResult : MissionResult {
  std::size_t lost_count = 0;
  Pose2 T_map_start;                   ///< of the mission's path
  std::vector<LandmarkCycle> cycles;   ///< for refinement
  std::vector<LandmarkFix> fixes;      ///< one per cycle
  std::vector<Pose2> T_world_vehicle;  ///< true poses, one per cycle; empty: unknown
};

/// Lets a vehicle near the path's start drive the path.
/// @param truth  of the vehicle; null: unknown
Result<LandmarkMissionResult> drive_landmark_mission(Vehicle& vehicle, const TruthSource* truth,
                                                     LandmarkDriver& driver,
                                                     std::optional<SessionRecord>& session,
                                                     Progress& progress);

/// SVG document of the landmarks, the planned path, the trace and what was seen on it (C98 Fig. 12).
std::string trace_picture(const Building& building, const LandmarkMissionResult& result,
                          const std::string& title);

}  // namespace aisle
