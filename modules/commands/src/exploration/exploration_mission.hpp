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

/// Result of a simulated exploration.
struct ExplorationMissionResult {
  MissionEnd end;
  ExplorationRecord record;
  LaserLog log;  ///< what the sensor saw, scan by scan
  std::size_t collisions = 0;
  double distance_m = 0;
  std::vector<Pose2> T_world_vehicle;  ///< true poses, one per cycle
  std::vector<Pose2> T_world_scan;     ///< true poses, one per scan
  std::vector<double> cycle_s;         ///< processor time of each cycle, from observation to command
};

/// Puts the vehicle at its start and lets it explore, or continue an interrupted run (`former`).
Result<ExplorationMissionResult> drive_exploration(const SimulationSetting& setting,
                                                   ExplorerNavigator& navigator, const Pose2& T_world_start,
                                                   std::uint64_t seed, std::optional<InterruptedRun> former,
                                                   std::optional<SessionRecord>& session, Progress& progress);

}  // namespace aisle
