#pragma once

#include <span>
#include <vector>

#include "aisle/learning/landmarks/landmark_learning.hpp"
#include "landmarks/landmark_loops.hpp"
#include "landmarks/landmark_observations.hpp"
#include "landmarks/run_walls.hpp"

namespace aisle {

/// What was recorded and matched on a run.
struct RunEvidence {
  std::span<const LandmarkCycle> cycles;
  std::span<const LandmarkObservation> observations;
  std::span<const LandmarkLoop> loops;
  std::span<const WallObservation> walls;
  std::span<const Landmark> known = {};  ///< from earlier runs: the first of the landmarks
};

/// Adjusts the poses of a run and its landmarks until sightings, odometry, walls and loops agree best (robust
/// least squares). Without known landmarks the first pose is fixed; otherwise these hold the map in place,
/// each as firmly as it is known. Systematic odometry errors and each image's tilt are unknowns, too.
/// Landmarks get the covariance that all their sightings leave.
/// @return for each landmark, the scatter of its sightings in `map` beyond their own errors
std::vector<Mat2> adjust_landmarks(const RunEvidence& run, const VehicleDescription& vehicle,
                                   std::vector<Pose2>& T_map_vehicle, std::vector<Landmark>& landmarks);

}  // namespace aisle
