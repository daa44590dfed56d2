#pragma once

#include <cstddef>

#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// A relative pose of the vehicle between two scans of a log, known from elsewhere.
struct PoseRelation {
  std::size_t scan_1 = 0;  ///< index into LaserLog::scans
  std::size_t scan_2 = 0;
  Pose2 T_1_2;  ///< the vehicle at scan_2, seen from the vehicle at scan_1
};

}  // namespace aisle
