#pragma once

#include "aisle/core/angle.hpp"
#include "aisle/geometry/pose2.hpp"
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

/// The segment in the frame of another sensor.
inline SensedSegment operator*(const Pose2& T_to_from, SensedSegment segment) {
  segment.segment = T_to_from * segment.segment;
  segment.centroid = T_to_from * segment.centroid;
  segment.heading_rad = wrap_angle(segment.heading_rad + T_to_from.theta);
  return segment;
}

}  // namespace aisle
