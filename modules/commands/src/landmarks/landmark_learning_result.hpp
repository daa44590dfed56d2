#pragma once

#include <string>
#include <vector>

#include "aisle/control/path_fit.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/core/result.hpp"
#include "aisle/maps/building.hpp"
#include "landmarks/landmark_run.hpp"

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

/// What was learned of a run.
struct LandmarkLearningResult {
  Building building;
  std::vector<Pose2> T_map_taught;  ///< of each of the run's cycles
};

/// C98 Algorithm 2, and the route as it was driven. A run that shows no landmarks, or a path that the vehicle
/// cannot drive, is a problem.
Result<LandmarkLearningResult> learn_route(const LandmarkRun& run, const std::string& route,
                                           const LandmarkLearnerParams& params);

/// A refining run in which fewer of the images fit the map is not of its building.
inline constexpr double kKnownShareMin = 0.5;

/// Where a run may begin that is said to begin there.
UncertainPose2 about_start(const Pose2& T_map_start);

}  // namespace aisle
