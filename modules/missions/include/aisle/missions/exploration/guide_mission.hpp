#pragma once

#include <optional>
#include <vector>

#include "aisle/core/progress.hpp"
#include "aisle/core/result.hpp"
#include "aisle/formats/sessions/session_record.hpp"
#include "aisle/missions/exploration/goal_follower.hpp"
#include "aisle/missions/exploration/guide_driver.hpp"
#include "aisle/missions/mission_result.hpp"

namespace aisle {

/// Result of a mission in a known building.
struct GuideMissionResult : MissionResult {
  std::vector<Pose2> T_map_vehicle;    ///< estimated poses, one per cycle since it knows where it is
  std::vector<Pose2> T_world_vehicle;  ///< true poses at the same cycles; empty: unknown
};

/// Lets a vehicle drive to its goal, from where the driver says that it begins.
/// @param truth  of the vehicle; null: unknown
Result<GuideMissionResult> drive_guide_mission(Vehicle& vehicle, const TruthSource* truth,
                                               GuideDriver& driver, std::optional<SessionRecord>& session,
                                               Progress& progress);

/// Lets a vehicle follow goals until it ends the mission; nobody knows the truth.
Result<GuideMissionResult> follow_goals(Vehicle& vehicle, GoalFollower& follower,
                                        std::optional<SessionRecord>& session, Progress& progress);

/// Share of the length of all corridors to which the vehicle's centre line came within half a metre.
double graph_coverage(const CorridorGraph& graph, const std::vector<Pose2>& T_map_vehicle,
                      const Footprint& footprint);

}  // namespace aisle
