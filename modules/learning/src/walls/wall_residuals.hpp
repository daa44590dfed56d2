#pragma once
/// The residuals that the adjustment of keyframes and walls balances, with their derivatives.

#include <array>
#include <cmath>

#include "aisle/core/angle.hpp"
#include "aisle/geometry/sensed_segment.hpp"
#include "aisle/matching/wall_estimate.hpp"

namespace aisle {

/// The present motion between two keyframes against the tracked one: (x, y, theta) in the frame of the first.
struct MotionResidual {
  Vec3 off;
  Mat3 by_from, by_to;  ///< by (x, y, theta) of each keyframe in `map`

  MotionResidual(const Pose2& T_map_from, const Pose2& T_map_to, const Pose2& tracked) {
    const Pose2 present = between(T_map_from, T_map_to);
    off = {present.x - tracked.x, present.y - tracked.y, wrap_angle(present.theta - tracked.theta)};
    const double c = std::cos(T_map_from.theta), s = std::sin(T_map_from.theta);
    by_from << -c, -s, present.y, s, -c, -present.x, 0, 0, -1;
    by_to << c, s, 0, -s, c, 0, 0, 0, 1;
  }
};

/// A segment seen from a keyframe against its wall.
struct SegmentResidual {
  double offset_m;                  ///< of its centroid, along the wall's normal
  double turn_rad;                  ///< its derivative: 1 by the keyframe's theta, -1 by the wall's turn
  std::array<double, 5> offset_by;  ///< by x, y, theta of the keyframe, the wall's shift along its normal
                                    ///< and, for oblique walls only, its turn about the anchor

  SegmentResidual(const SensedSegment& segment, const Pose2& T_map_sensor, const WallEstimate& wall) {
    const Vec2 lever = rotate(T_map_sensor.theta, segment.centroid);
    const Vec2 centroid = lever + T_map_sensor.position();
    offset_m = wall.offset_of(centroid);
    turn_rad = wrap_angle(T_map_sensor.theta + segment.heading_rad - wall.heading_rad);
    offset_by = {wall.normal.x(), wall.normal.y(), wall.normal.dot(left_normal(lever)), -1,
                 -wall.along.dot(centroid - wall.anchor)};
  }
};

}  // namespace aisle
