#pragma once
/// A route of sections in simulation, taught and learned.

#include <cstdint>

#include "aisle/commands/simulation_setting.hpp"
#include "aisle/evaluation/sections/section_evaluation.hpp"
#include "aisle/missions/sections/section_learning_result.hpp"

namespace aisle {

struct SectionCourse {
  SectionLearningResult learned;
  Pose2 T_world_map;  ///< of the taught run's map
};

/// A scripted person drives the world's tour `teachings` times, and the route is learned. A problem says why
/// not: the person did not get through, or went nowhere.
Result<SectionCourse> teach_sections(const SimulationSetting& setting, const SectionLearnerParams& params,
                                     std::uint64_t seed, int teachings, Progress& progress);

/// The vehicle, put down near the course's start, drives there and back.
Result<JudgedSectionMission> drive_there_and_back(const SimulationSetting& setting,
                                                  const SectionNavigatorParams& params,
                                                  const SectionCourse& course, std::uint64_t seed,
                                                  bool keeps_images, Progress& progress);

}  // namespace aisle
