#pragma once

#include <span>
#include <vector>

#include "aisle/learning/landmarks/landmark_learning.hpp"
#include "landmarks/landmark_loops.hpp"
#include "landmarks/landmark_observations.hpp"
#include "landmarks/run_walls.hpp"

namespace aisle {

/// What is known of a run and of what it saw.
struct RunEvidence {
  std::span<const LandmarkCycle> cycles;
  std::span<const LandmarkObservation> observations;
  std::span<const LandmarkLoop> loops;
  std::span<const WallObservation> walls;
  std::span<const Landmark> known = {};  ///< by earlier runs: the first of the landmarks
};

/// Moves the poses of a run and its landmarks until sightings, odometry and walls agree best (robust least
/// squares), and what loops say of two poses holds. Without landmarks that are known the first pose stays;
/// else these hold the map where it is, each as firmly as it is known. What is steadily wrong with the
/// odometry, and each image's tilt, are unknowns, too. Landmarks get the covariance that all their
/// sightings leave.
/// @return of each landmark, how far its sightings scatter about it, in `map`, beyond their own errors
std::vector<Mat2> adjust_landmarks(const RunEvidence& run, const VehicleDescription& vehicle,
                                   std::vector<Pose2>& T_map_vehicle, std::vector<Landmark>& landmarks);

}  // namespace aisle
