#pragma once

#include <optional>
#include <span>

#include "aisle/geometry/sensed_segment.hpp"

namespace aisle {

/// What an edge of the floor, which should lie along an axis, tells of the heading.
struct AxisMisfit {
  double off_rad = 0;    ///< by which it would lie turned against the nearest axis, counter-clockwise
  double sigma_rad = 0;  ///< of a straight wall's, whoever looks
  double usual_rad = 0;  ///< off by more, it is less and less likely to be one: doors, recesses
};

/// @return nullopt for an edge too short to have a direction, or a short one whose direction is hardly seen
std::optional<AxisMisfit> misfit_to_axis(const SensedSegment& edge, double heading_rad);

struct HeadingMeasurement {
  double heading_rad = 0;  ///< of the sensor in a map whose axes the walls run along
  double sigma_rad = 0;
};

/// The sensor's heading from the walls' orthogonality alone, near a predicted heading. No value where too
/// little wall is seen or less than half of it agrees: the scan is no witness then.
std::optional<HeadingMeasurement> heading_from_walls(std::span<const SensedSegment> segments,
                                                     double predicted_rad, double predicted_sigma_rad);

}  // namespace aisle
