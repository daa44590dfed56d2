#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "aisle/core/progress.hpp"
#include "aisle/core/result.hpp"
#include "aisle/formats/sessions/session_record.hpp"
#include "aisle/guidance/landmarks/landmark_navigator.hpp"
#include "aisle/guidance/mission.hpp"
#include "aisle/learning/landmarks/landmark_learning.hpp"
#include "landmarks/landmark_driver.hpp"
#include "landmarks/landmark_evaluation.hpp"
#include "simulation_setting.hpp"

namespace aisle {

/// Result of a simulated mission along a learned route.
struct LandmarkMissionResult {
  MissionEnd end;
  std::size_t collisions = 0;
  std::size_t lost_count = 0;
  double distance_m = 0;
  MissionErrors errors;
  std::vector<double> cycle_s;        ///< processor time of each cycle, from image to command
  Pose2 T_map_start;                  ///< of the mission's path
  std::vector<LandmarkCycle> cycles;  ///< for refinement
  std::vector<Pose2> T_map_driven;    ///< estimated poses, one per cycle
};

struct LandmarkMissionOptions {
  std::uint64_t seed = 1;
  bool in_reverse = false;      ///< the path is a route's return path
  double start_sigma_m = 0.05;  ///< deviation of the initial pose from the route's start
  double start_sigma_rad = 1 * kDegree;
};

/// Puts the vehicle near the path's start and lets it drive the path.
Result<LandmarkMissionResult> drive_landmark_mission(const SimulationSetting& setting, LandmarkDriver& driver,
                                                     const MapTruth& truth,
                                                     const LandmarkMissionOptions& options,
                                                     std::optional<SessionRecord>& session,
                                                     Progress& progress);

/// The figures of a mission as `navigate` prints them.
nlohmann::ordered_json figures_of(const LandmarkMissionResult& result);

/// SVG document of the landmarks, the planned path, the trace and what was seen on it (C98 Fig. 12).
std::string trace_picture(const Building& building, const LandmarkMissionResult& result,
                          const std::string& title);

}  // namespace aisle
