#pragma once

#include <string>
#include <vector>

#include "aisle/control/path_fit.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/core/result.hpp"
#include "aisle/maps/building.hpp"
#include "landmarks/landmark_trip.hpp"

namespace aisle {

struct LandmarkLessonParams {
  LandmarkSightingParams sightings;
  LandmarkLearningParams learning;
  PathFitParams path;

  void describe(FieldList& fields) {
    fields.group("sightings", sightings);
    fields.group("learning", learning);
    fields.group("path", path);
  }
};

/// What was learned of a trip.
struct LandmarkLesson {
  Building building;
  std::vector<Pose2> T_map_taught;  ///< of each of the trip's cycles
};

/// C98 Algorithm 2, and the route as it was driven. A trip that shows no landmarks, or a way that the vehicle
/// cannot drive, is a problem.
Result<LandmarkLesson> learn_lesson(const LandmarkTrip& trip, const std::string& route,
                                    const LandmarkLessonParams& params);

/// A refining trip in which fewer of the pictures fit the map is not of its building.
inline constexpr double kKnownShareMin = 0.5;

/// Where a trip may begin that is said to begin there.
UncertainPose2 about_start(const Pose2& T_map_start);

}  // namespace aisle
