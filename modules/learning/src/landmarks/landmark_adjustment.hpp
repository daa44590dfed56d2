#pragma once

#include <span>
#include <vector>

#include "aisle/learning/landmarks/landmark_learning.hpp"
#include "landmarks/landmark_loops.hpp"

namespace aisle {

/// That a sighting of a cycle shows a landmark.
struct LandmarkObservation {
  std::size_t cycle = 0;
  std::size_t sighting = 0;
  std::size_t landmark = 0;
};

/// The heading of the vehicle in a cycle against the walls around.
struct WallObservation {
  std::size_t cycle = 0;
  int walls = 0;  ///< whose direction is one unknown, from 0 on
  HeadingMeasurement against_walls;
};

/// Moves the poses of a trip and its landmarks until sightings, odometry and walls agree best (robust least
/// squares); the first pose stays, and what loops say of two poses holds. What is steadily wrong with the
/// odometry, and each picture's tilt, are unknowns, too. Landmarks get the covariance that their sightings
/// leave.
void adjust_landmarks(std::span<const LandmarkCycle> cycles,
                      std::span<const LandmarkObservation> observations, std::span<const LandmarkLoop> loops,
                      std::span<const WallObservation> walls, const VehicleDescription& vehicle,
                      std::vector<Pose2>& T_map_vehicle, std::vector<Landmark>& landmarks);

}  // namespace aisle
