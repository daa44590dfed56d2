#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "aisle/core/progress.hpp"
#include "aisle/core/result.hpp"
#include "aisle/formats/sessions/session_record.hpp"
#include "aisle/guidance/mission.hpp"
#include "exploration/guide_driver.hpp"
#include "simulation_setting.hpp"

namespace aisle {

/// Result of a simulated mission in a known building.
struct GuideMissionResult {
  MissionEnd end;
  std::size_t collisions = 0;
  double distance_m = 0;
  std::vector<Pose2> T_map_vehicle;    ///< estimated poses, one per cycle
  std::vector<Pose2> T_world_vehicle;  ///< true poses, one per cycle
  std::vector<double> cycle_s;         ///< processor time of each cycle, from observation to command
};

/// Puts the vehicle near home, which lies at the world's start, and lets it drive.
Result<GuideMissionResult> drive_guide_mission(const SimulationSetting& setting, GuideDriver& driver,
                                               const Pose2& T_world_start, std::uint64_t seed,
                                               std::optional<SessionRecord>& session, Progress& progress);

/// Share of the length of all corridors to which the vehicle's centre line came within half a metre.
double graph_coverage(const CorridorGraph& graph, const std::vector<Pose2>& T_map_vehicle,
                      const Footprint& footprint);

}  // namespace aisle
