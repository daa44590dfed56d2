#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "aisle/learning/landmarks/landmark_learning.hpp"
#include "landmarks/run_landmarks.hpp"

namespace aisle {

/// A sighting of a cycle shows a landmark.
struct LandmarkObservation {
  std::size_t cycle = 0;
  std::size_t sighting = 0;
  std::size_t landmark = 0;
};

/// Matches the sightings of a run with landmarks, given poses known to a few centimetres.
std::vector<LandmarkObservation> observe_landmarks(std::span<const LandmarkCycle> cycles,
                                                   const VehicleDescription& vehicle,
                                                   const LandmarkLocaliserParams& params,
                                                   std::span<const Pose2> T_map_vehicle,
                                                   std::span<const RunLandmark> landmarks);

}  // namespace aisle
