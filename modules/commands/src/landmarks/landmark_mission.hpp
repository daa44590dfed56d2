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

/// What a simulated mission along a learned route came to.
struct LandmarkMissionResult {
  MissionEnd end;
  std::size_t collisions = 0;
  std::size_t lost_count = 0;
  double distance_m = 0;
  MissionErrors errors;
  std::vector<double> cycle_s;        ///< processor time of each cycle, from image to command
  Pose2 T_map_start;                  ///< of its path
  std::vector<LandmarkCycle> cycles;  ///< for refinement
  std::vector<Pose2> T_map_driven;    ///< of each cycle, as the vehicle thought
};

struct LandmarkMissionOptions {
  std::uint64_t seed = 1;
  bool in_reverse = false;      ///< the path is a route's return path
  double start_sigma_m = 0.05;  ///< how far beside the route's start the vehicle is set down
  double start_sigma_rad = 1 * kDegree;
};

/// Sets the vehicle down about the path's start and lets it drive there by itself.
Result<LandmarkMissionResult> drive_landmark_mission(const SimulationSetting& setting, LandmarkDriver& driver,
                                                     const MapTruth& truth,
                                                     const LandmarkMissionOptions& options,
                                                     std::optional<SessionRecord>& session,
                                                     Progress& progress);

/// The figures of a mission as `navigate` prints them.
nlohmann::ordered_json figures_of(const LandmarkMissionResult& result);

/// Planned path, trace and what was seen on the way (C98 Fig. 12), among the landmarks: an SVG document.
std::string trace_picture(const Building& building, const LandmarkMissionResult& result,
                          const std::string& title);

}  // namespace aisle
