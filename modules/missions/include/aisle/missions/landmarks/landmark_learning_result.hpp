#pragma once

#include <string>
#include <vector>

#include "aisle/control/path_fit.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/core/result.hpp"
#include "aisle/maps/building.hpp"
#include "aisle/missions/landmarks/landmark_run.hpp"

namespace aisle {

struct LandmarkLearnerParams {
  LandmarkSightingParams sightings;
  LandmarkLearningParams learning;
  PathFitParams path;

  void describe(FieldList& fields) {
    fields.group("sightings", sightings);
    fields.group("learning", learning);
    fields.group("path", path);
  }
};

/// What was learned from a run.
struct LandmarkLearningResult {
  Building building;
  std::vector<Pose2> T_map_taught;  ///< one per cycle of the run
};

/// Learns landmarks (C98 Algorithm 2) and the route as it was driven. A run that shows no landmarks, or a
/// path that the vehicle cannot drive, is a problem.
Result<LandmarkLearningResult> learn_route(const LandmarkRun& run, const std::string& route,
                                           const LandmarkLearnerParams& params);

/// If a smaller share of its images fits the map, a refining run is not of this building.
inline constexpr double kKnownShareMin = 0.5;

/// The pose, and its uncertainty, of a run that is said to begin at `T_map_start`.
UncertainPose2 about_start(const Pose2& T_map_start);

}  // namespace aisle
