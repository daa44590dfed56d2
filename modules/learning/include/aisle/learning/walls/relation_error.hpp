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

/// Where the frame of the relations sits on the vehicle: the logs they were made of may give the poses of
/// another point, such as the laser. Found as a scanner's mounting is; only a position that is known to
/// differ from the vehicle's by three standard deviations and 2 cm, else the identity.
Pose2 frame_of_relations(std::span<const Pose2> T_map_vehicle, std::span<const PoseRelation> relations);

/// The relations' scans must be indices of the trajectory.
RelationError relation_error(std::span<const Pose2> T_map_vehicle, std::span<const PoseRelation> relations);

}  // namespace aisle
