#pragma once

#include <optional>
#include <span>

#include "aisle/geometry/sensed_segment.hpp"

namespace aisle {

struct HeadingMeasurement {
  double heading_rad = 0;  ///< of the sensor in a map whose axes the walls run along
  double sigma_rad = 0;
};

/// The sensor's heading from the walls' orthogonality alone, near a predicted heading. No value where too
/// little wall is seen or less than half of it agrees: the scan is no witness then.
std::optional<HeadingMeasurement> heading_from_walls(std::span<const SensedSegment> segments,
                                                     double predicted_rad, double predicted_sigma_rad);

}  // namespace aisle
