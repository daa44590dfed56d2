#pragma once
/// Base lines as walls beside a straight path (L03 section 3.1 C: the safe distance), and across it.

#include <span>
#include <vector>

#include "aisle/geometry/pose2.hpp"
#include "aisle/geometry/sensed_segment.hpp"

namespace aisle {

/// A base line that runs along a path.
struct WallBeside {
  double lateral_m = 0;  ///< to the left of the path
  double length_m = 0;   ///< that is seen
  double from_m = 0;     ///< along the path, from its start
  double to_m = 0;
  double sigma_m = 0;             ///< of `lateral_m`
  Vec2 p_vehicle = Vec2::Zero();  ///< the middle of what is seen
};

/// Those of the edges that run along a path within 8 degrees, at least 0.2 m of them.
/// @param edges            in base_link
/// @param T_path_vehicle    the vehicle in a frame whose x axis is the path
/// @param beside           filled
void find_walls_beside(std::span<const SensedSegment> edges, const Pose2& T_path_vehicle,
                       std::vector<WallBeside>& beside);

/// A base line that runs across a path.
struct WallAcross {
  double along_m = 0;  ///< the path, from its start: where the vehicle is and how far from it the wall, by
                       ///< the wall's own direction, so that the vehicle's heading does not matter
  double from_m = 0;   ///< beside the path, to the left
  double to_m = 0;
  double sigma_m = 0;  ///< of `along_m`
};

/// Those of the edges that run across a path within 8 degrees, at least 0.2 m of them.
void find_walls_across(std::span<const SensedSegment> edges, const Pose2& T_path_vehicle,
                       std::vector<WallAcross>& across);

}  // namespace aisle
