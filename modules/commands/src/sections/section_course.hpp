#pragma once
/// The life of a path of sections in simulation, up to where the vehicle drives it alone.

#include <cstdint>

#include "sections/section_learning_result.hpp"
#include "simulation_setting.hpp"

namespace aisle {

struct SectionCourse {
  SectionLearningResult learned;
  Pose2 T_world_map;  ///< of the taught run's map
};

/// A person drives the world's tour once or more often, and it is learned. A problem says why it was not: the
/// person did not get through, or went nowhere.
Result<SectionCourse> teach_sections(const SimulationSetting& setting, const SectionLearnerParams& params,
                                     std::uint64_t seed, int teachings, Progress& progress);

}  // namespace aisle
