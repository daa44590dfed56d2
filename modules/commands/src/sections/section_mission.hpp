#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "aisle/core/progress.hpp"
#include "aisle/core/result.hpp"
#include "aisle/formats/sessions/session_record.hpp"
#include "aisle/guidance/mission.hpp"
#include "aisle/guidance/sections/section_navigator.hpp"
#include "aisle/report/picture_sheet.hpp"
#include "landmarks/landmark_evaluation.hpp"
#include "simulation_setting.hpp"

namespace aisle {

/// Result of a simulated mission by sections.
struct SectionMissionResult {
  MissionEnd end;
  std::size_t collisions = 0;
  double distance_m = 0;
  double closing_error_m = 0;  ///< true distance of the end from the start if it drove back, else from the
                               ///< path's end
  double closing_error_rad = 0;
  ErrorFigure wall_distance_m;  ///< error of the distance to the right wall-floor edge, while it was followed
  std::vector<double> cycle_s;  ///< processor time of each cycle, from image to command
  std::vector<Pose2> T_map_driven;   ///< estimated poses, one per cycle
  std::vector<TakenPicture> images;  ///< from the middles of longer straight sections, with keep_images
};

struct SectionMissionOptions {
  std::uint64_t seed = 1;
  Pose2 T_world_map;            ///< the map's frame in the world, near the path's start
  double start_sigma_m = 0.02;  ///< deviation of the initial pose from the path's start
  double start_sigma_rad = 1 * kDegree;
  bool keep_images = false;
};

/// Puts the vehicle near the path's start and lets it drive the path.
Result<SectionMissionResult> drive_section_mission(const SimulationSetting& setting,
                                                   SectionNavigator& navigator,
                                                   const SectionMissionOptions& options,
                                                   std::optional<SessionRecord>& session, Progress& progress);

/// The figures of a mission as `navigate` prints them.
nlohmann::ordered_json figures_of(const SectionMissionResult& result);

}  // namespace aisle
