#pragma once

#include <span>

#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// A point in two frames, or before and after a displacement.
struct PointPair {
  Vec2 from = Vec2::Zero();
  Vec2 to = Vec2::Zero();
};

/// The rigid displacement T that minimises the sum of squared distances between T * from and to. Needs at
/// least two pairs.
Pose2 fit_points(std::span<const PointPair> pairs);

}  // namespace aisle
