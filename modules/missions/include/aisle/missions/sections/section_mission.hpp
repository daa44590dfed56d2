#pragma once

#include <optional>
#include <vector>

#include "aisle/core/progress.hpp"
#include "aisle/core/result.hpp"
#include "aisle/formats/sessions/session_record.hpp"
#include "aisle/guidance/sections/section_navigator.hpp"
#include "aisle/missions/mission_result.hpp"
#include "aisle/report/picture_sheet.hpp"

namespace aisle {

/// A cycle in which the wall-floor edge to the right was followed.
struct FollowedEdge {
  std::size_t piece = 0;   ///< of the path
  double heading_rad = 0;  ///< of the path, in the map
  double learned_m = 0;    ///< learned distance from the edge
  Pose2 T_world_vehicle;   ///< true pose
};

/// Result of a mission by sections.
struct SectionMissionResult : MissionResult {
  std::vector<Pose2> T_map_driven;     ///< estimated poses, one per cycle
  std::vector<FollowedEdge> followed;  ///< empty where the truth is unknown
  std::vector<TakenPicture> images;    ///< from the middles of longer straight sections, if they are kept
};

/// Lets a vehicle near the path's start drive the path.
/// @param truth  of the vehicle; null: unknown
Result<SectionMissionResult> drive_section_mission(Vehicle& vehicle, const TruthSource* truth,
                                                   SectionNavigator& navigator, bool keeps_images,
                                                   std::optional<SessionRecord>& session, Progress& progress);

}  // namespace aisle
