#pragma once

#include <algorithm>

#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// A straight piece of wall in the plane [m]. Directed: the side it was seen from lies on its LEFT.
struct Segment2 {
  Vec2 start = Vec2::Zero();
  Vec2 end = Vec2::Zero();

  double length() const { return (end - start).norm(); }
  Vec2 midpoint() const { return (start + end) / 2; }
  /// Direction from start to end [rad].
  double heading() const { return heading_of(end - start); }
  Segment2 reversed() const { return {end, start}; }
  /// Distance from the point to the nearest point of the segment [m].
  double distance(const Vec2& p) const {
    const Vec2 along = end - start;
    const double square = along.squaredNorm();
    const double share = square > 0 ? std::clamp((p - start).dot(along) / square, 0.0, 1.0) : 0;
    return (p - (start + share * along)).norm();
  }
};

inline Segment2 operator*(const Pose2& T, const Segment2& s) {
  return {T * s.start, T * s.end};
}

/// Whether two segments cross; those that only touch may count either way.
inline bool cross(const Segment2& a, const Segment2& b) {
  const auto side = [](const Segment2& s, const Vec2& p) {
    const Vec2 along = s.end - s.start, off = p - s.start;
    return along.x() * off.y() - along.y() * off.x() > 0;
  };
  return side(a, b.start) != side(a, b.end) && side(b, a.start) != side(b, a.end);
}

/// What the end of a piece of wall is known to be.
enum class WallEnd {
  kSeen,     ///< a true end: a corner, or the wall stops and something behind it was seen
  kUnknown,  ///< only the limit of sight: the wall may go on
};

/// A range on a line [m]; min <= max.
struct Interval {
  double min = 0;
  double max = 0;

  double length() const { return max - min; }
  Interval united(const Interval& other) const {
    return {std::min(min, other.min), std::max(max, other.max)};
  }
  /// Length of the common part; negative: the gap between the two.
  double overlap(const Interval& other) const { return std::min(max, other.max) - std::max(min, other.min); }
};

}  // namespace aisle
