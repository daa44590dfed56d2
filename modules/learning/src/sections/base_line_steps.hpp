#pragma once

#include <span>
#include <vector>

#include "aisle/geometry/pose2.hpp"
#include "aisle/geometry/sensed_segment.hpp"

namespace aisle {

/// What a vehicle sees on its path along a straight segment, in one cycle.
struct PathSegmentView {
  Pose2 T_path_segment_vehicle;
  std::span<const SensedSegment> edges;  ///< in base_link
};

/// Where, along a straight segment, a base line beside it steps to the side for good, as the corridor gets
/// wider or narrower there. Doors, recesses and furniture are too short for that. In ascending order; not
/// near the ends.
std::vector<double> base_line_steps_m(double length_m, std::span<const PathSegmentView> views);

}  // namespace aisle
