#pragma once

#include <span>
#include <vector>

#include "aisle/geometry/pose2.hpp"
#include "aisle/learning/landmarks/landmark_localiser.hpp"
#include "landmarks/run_landmarks.hpp"

namespace aisle {

/// That a run came to a place again: how the pose of a later cycle lies to that of an earlier one.
struct LandmarkLoop {
  std::size_t earlier_cycle = 0;
  std::size_t later_cycle = 0;
  Pose2 T_earlier_later;
};

/// Compares the landmarks of each segment of a run with those of every earlier pass that may have come by
/// the same place, as far as odometry and landmarks may have drifted on the way between. A loop needs many
/// landmarks that fall upon each other, at one displacement only, and a second segment that says the same.
std::vector<LandmarkLoop> find_landmark_loops(std::span<const RunLandmark> landmarks,
                                              std::span<const Pose2> T_map_vehicle,
                                              const LandmarkLocaliserParams& params);

}  // namespace aisle
