#pragma once
/// How well a mission by sections kept to what was taught. No navigator ever sees any of this.

#include <nlohmann/json.hpp>
#include <optional>

#include "aisle/evaluation/error_figure.hpp"
#include "aisle/missions/sections/section_mission.hpp"
#include "aisle/simulation/world.hpp"

namespace aisle {

struct SectionErrors {
  double closing_m = 0;  ///< true distance of the end from the start if it drove back, else from the path's
                         ///< end
  double closing_rad = 0;
  ErrorFigure wall_distance_m;  ///< of the distance to the right wall-floor edge, while it was followed
};

/// A mission and, where the truth is known, its errors.
struct JudgedSectionMission {
  SectionMissionResult mission;
  std::optional<SectionErrors> errors;
};

/// Where a mission by sections took place.
struct SectionPlace {
  const World& world;
  Pose2 T_world_map;    ///< the map's frame in the world, near the path's start
  Pose2 T_world_start;  ///< initial pose of the vehicle
};

JudgedSectionMission judged(SectionMissionResult mission, const SectionNavigator& navigator,
                            const SectionPlace& place);

/// The figures of a mission as `navigate` prints them.
nlohmann::ordered_json figures_of(const JudgedSectionMission& judged);

}  // namespace aisle
