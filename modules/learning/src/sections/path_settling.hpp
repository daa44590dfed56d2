#pragma once

#include <span>
#include <vector>

#include "aisle/learning/sections/section_learning.hpp"

namespace aisle {

inline constexpr double kAcrossNear_m = 2.5;  ///< of a wall ahead: there its distance is known well
inline constexpr double kPathWidth_m = 0.3;   ///< a wall ahead stands on the way itself

/// A straight segment of a drive, along one of the axes.
struct DrivenPathSegment {
  std::size_t first = 0, end = 0;  ///< of the drive's cycles
  double heading_rad = 0;
};

/// The path of a whole drive from the origin on, as odometry and all edges of the floor together make it most
/// probable; the odometry's steady errors are found with it. Walls stand at right angles, along the axes;
/// those beside a straight segment are one line on either side, and the one across its end is, where the path
/// turns, the outer one beside the next. An edge that lies misaligned or elsewhere has
/// little say, and what was seen later counts, too.
/// @param headings_rad  one a cycle, right to some degrees
std::vector<Pose2> settled_path(std::span<const SectionCycle> cycles, const VehicleDescription& vehicle,
                                std::vector<double> headings_rad,
                                std::span<const DrivenPathSegment> path_segments);

}  // namespace aisle
