#pragma once

#include <optional>
#include <span>

#include "aisle/geometry/sensed_segment.hpp"

namespace aisle {

/// The orthogonal frame that most wall length lies on.
struct DominantDirection {
  double heading_rad = 0;  ///< of one axis of the frame, in [-pi/4, pi/4)
  double share = 0;        ///< of the length of all segments that lies within 2.5 degrees of the axes, 0 .. 1
};

/// Found as the mode of all headings modulo 90 degrees, bent walls left out. No value if less than 1.5 m of
/// wall was seen. O(n^2) in the number of segments.
std::optional<DominantDirection> dominant_direction(std::span<const SensedSegment> segments);

}  // namespace aisle
