#pragma once

#include "aisle/geometry/segment2.hpp"

namespace aisle {

/// A straight piece of wall as one sensor saw it, in the sensor's frame; the sensor lies on its LEFT.
/// Its points are represented by two numbers with standard deviations: the centroid's offset across the line,
/// and the heading.
struct SensedSegment {
  Segment2 segment;
  Vec2 centroid = Vec2::Zero();
  double heading_rad = 0;  ///< from start to end
  double length_m = 0;
  double sigma_offset_m = 0;
  double sigma_heading_rad = 0;
  WallEnd start = WallEnd::kUnknown;
  WallEnd end = WallEnd::kUnknown;
  bool curved =
      false;  ///< a chord of a bent wall: its place is true, but it tells nothing of the building's axes
};

}  // namespace aisle
