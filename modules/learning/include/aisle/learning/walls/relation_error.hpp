#pragma once

#include <cstddef>
#include <span>

#include "aisle/vehicle/pose_relation.hpp"

namespace aisle {

struct MeanAndDeviation {
  double mean = 0;
  double deviation = 0;  ///< of the sample; 0 for fewer than two values
};

/// Error of a trajectory against known relations (Kuemmerle et al. 2009): every relation counts, without
/// alignment.
struct RelationError {
  std::size_t count = 0;
  MeanAndDeviation translation_m;
  MeanAndDeviation rotation_rad;
};

/// The relations' scans must be indices of the trajectory.
RelationError relation_error(std::span<const Pose2> T_map_vehicle, std::span<const PoseRelation> relations);

}  // namespace aisle
