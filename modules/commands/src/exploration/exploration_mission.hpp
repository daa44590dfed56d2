#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "aisle/core/progress.hpp"
#include "aisle/core/result.hpp"
#include "aisle/formats/sessions/session_record.hpp"
#include "aisle/guidance/exploration/explorer_navigator.hpp"
#include "aisle/guidance/mission.hpp"
#include "exploration/exploration_run.hpp"
#include "simulation_setting.hpp"

namespace aisle {

/// What a simulated exploration came to.
struct ExplorationMissionResult {
  MissionEnd end;
  ExplorationRecord record;
  LaserLog log;  ///< what the sensor saw, scan by scan
  std::size_t collisions = 0;
  double distance_m = 0;
  std::vector<Pose2> T_world_vehicle;  ///< as it was, one a cycle
  std::vector<Pose2> T_world_scan;     ///< as it was, one a scan
  std::vector<double> cycle_s;         ///< processor time of each cycle, from observation to command
};

/// Sets the vehicle down and lets it explore, or go on with a run that was interrupted.
Result<ExplorationMissionResult> drive_exploration(const SimulationSetting& setting,
                                                   ExplorerNavigator& navigator, const Pose2& T_world_start,
                                                   std::uint64_t seed, std::optional<InterruptedRun> former,
                                                   std::optional<SessionRecord>& session, Progress& progress);

}  // namespace aisle
