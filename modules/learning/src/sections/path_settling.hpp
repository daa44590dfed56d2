#pragma once

#include <span>
#include <vector>

#include "aisle/learning/sections/section_learning.hpp"

namespace aisle {

inline constexpr double kAcrossNear_m = 2.5;  ///< a wall ahead is measured well up to this distance
inline constexpr double kPathWidth_m = 0.3;   ///< half the path's width, in which a wall ahead must be

/// A straight segment of a drive, along one of the axes.
struct DrivenPathSegment {
  std::size_t first = 0, end = 0;  ///< of the drive's cycles
  double heading_rad = 0;
};

/// The most probable path of a whole drive from the origin on, given the odometry, its systematic errors, and
/// all floor edges. Walls are at right angles, along the axes. Walls beside a straight segment are one line
/// on each side; the wall across its end is, where the path turns, the outer one beside the next. A
/// misaligned or displaced edge has little weight, and later observations count, too.
/// @param headings_rad  one per cycle, right to some degrees
std::vector<Pose2> settled_path(std::span<const SectionCycle> cycles, const VehicleDescription& vehicle,
                                std::vector<double> headings_rad,
                                std::span<const DrivenPathSegment> path_segments);

}  // namespace aisle
