#pragma once

#include <span>
#include <vector>

#include "aisle/geometry/pose2.hpp"
#include "aisle/learning/landmarks/landmark_localiser.hpp"
#include "landmarks/run_landmarks.hpp"

namespace aisle {

/// A loop of a run: the pose of a later cycle relative to an earlier one at the same place.
struct LandmarkLoop {
  std::size_t earlier_cycle = 0;
  std::size_t later_cycle = 0;
  Pose2 T_earlier_later;
};

/// Compares the landmarks of each segment of a run with those of every earlier pass that may have been at the
/// same place, given the drift possible in between. A loop needs many coinciding landmarks, at one
/// displacement only, and a second segment that agrees.
std::vector<LandmarkLoop> find_landmark_loops(std::span<const RunLandmark> landmarks,
                                              std::span<const Pose2> T_map_vehicle,
                                              const LandmarkLocaliserParams& params);

}  // namespace aisle
