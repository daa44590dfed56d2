#pragma once

#include <optional>
#include <span>

#include "aisle/geometry/sensed_segment.hpp"

namespace aisle {

/// What a floor edge, which should be parallel to an axis, says about the heading.
struct AxisMisfit {
  double off_rad = 0;    ///< its angle to the nearest axis, counter-clockwise
  double sigma_rad = 0;  ///< sigma for a straight wall
  double usual_rad = 0;  ///< an edge off by more is less and less likely a wall: doors, recesses
};

/// @return nullopt for an edge too short to have a direction, or a short one whose direction is hardly
///         visible
std::optional<AxisMisfit> misfit_to_axis(const SensedSegment& edge, double heading_rad);

struct HeadingMeasurement {
  double heading_rad = 0;  ///< of the sensor, in a map whose axes are parallel to the walls
  double sigma_rad = 0;
};

/// The sensor's heading from the walls' orthogonality alone, near a predicted heading. nullopt if too little
/// wall is seen or less than half of it agrees.
std::optional<HeadingMeasurement> heading_from_walls(std::span<const SensedSegment> segments,
                                                     double predicted_rad, double predicted_sigma_rad);

}  // namespace aisle
