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

/// What a simulated mission by sections came to.
struct SectionMissionResult {
  MissionEnd end;
  std::size_t collisions = 0;
  double distance_m = 0;
  double closing_error_m =
      0;  ///< by the truth: from where it began if it came home, else from where the path ends
  double closing_error_rad = 0;
  ErrorFigure wall_distance_m;  ///< to the right base line against the learned one, while one was followed
  std::vector<double> cycle_s;  ///< processor time of each cycle, from image to command
  std::vector<Pose2> T_map_driven;   ///< of each cycle, as the vehicle thought
  std::vector<TakenPicture> images;  ///< one from the middle of each longer straight section, if wanted
};

struct SectionMissionOptions {
  std::uint64_t seed = 1;
  Pose2 T_world_map;            ///< how the map lies in the world about the path's start
  double start_sigma_m = 0.02;  ///< how far beside it the vehicle is set down
  double start_sigma_rad = 1 * kDegree;
  bool keep_images = false;
};

/// Sets the vehicle down about the path's start and lets it drive there by itself.
Result<SectionMissionResult> drive_section_mission(const SimulationSetting& setting,
                                                   SectionNavigator& navigator,
                                                   const SectionMissionOptions& options,
                                                   std::optional<SessionRecord>& session, Progress& progress);

/// The figures of a mission as `navigate` prints them.
nlohmann::ordered_json figures_of(const SectionMissionResult& result);

}  // namespace aisle
