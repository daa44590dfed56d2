#pragma once

#include <optional>
#include <vector>

#include "aisle/core/progress.hpp"
#include "aisle/core/result.hpp"
#include "aisle/formats/sessions/session_record.hpp"
#include "aisle/guidance/exploration/explorer_navigator.hpp"
#include "aisle/missions/exploration/exploration_run.hpp"
#include "aisle/missions/mission_result.hpp"

namespace aisle {

/// Result of an exploration.
struct ExplorationMissionResult : MissionResult {
  ExplorationRecord record;
  LaserLog log;                     ///< what the sensor saw, scan by scan
  std::vector<Pose2> T_world_scan;  ///< true poses, one per scan; empty: unknown
};

/// Lets a vehicle explore from where it stands, or continue an interrupted run (`former`) where that ended.
/// @param truth  of the vehicle; null: unknown
Result<ExplorationMissionResult> drive_exploration(Vehicle& vehicle, const TruthSource* truth,
                                                   ExplorerNavigator& navigator,
                                                   std::optional<InterruptedRun> former,
                                                   std::optional<SessionRecord>& session, Progress& progress);

}  // namespace aisle
