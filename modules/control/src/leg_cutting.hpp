#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// Consecutive samples of a leg that lie along one line or arc.
struct PathSegment {
  std::size_t first = 0;       ///< sample
  std::size_t last = 0;        ///< the next segment begins there
  double curvature_per_m = 0;  ///< to the left in the direction of travel; 0: a line
};

/// Cuts a leg into lines and arcs so that the sum of squared distances times the samples' spacing, plus a
/// price for each piece, is least. Two lines never follow each other: they could not join without a kink.
/// @param price_m3  of an arc; a line costs half
std::vector<PathSegment> cut_leg(std::span<const Pose2> samples, double step_m, double radius_min_m,
                                 double price_m3);

}  // namespace aisle
