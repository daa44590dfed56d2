#pragma once

#include <span>
#include <vector>

#include "aisle/geometry/pose2.hpp"
#include "aisle/geometry/sensed_segment.hpp"

namespace aisle {

/// What a vehicle sees in one cycle on its path along a straight segment.
struct PathSegmentView {
  Pose2 T_path_segment_vehicle;
  std::span<const SensedSegment> edges;  ///< in base_link
};

/// Where a base line beside a straight segment steps to the side for good, because the corridor gets wider or
/// narrower. Doors, recesses and furniture are too short for that. In ascending order; not near the ends.
std::vector<double> base_line_steps_m(double length_m, std::span<const PathSegmentView> views);

}  // namespace aisle
