#pragma once
/// Base lines (wall-floor edges) as walls beside a straight path (L03 section 3.1 C: the safe distance), and
/// across it.

#include <span>
#include <vector>

#include "aisle/geometry/pose2.hpp"
#include "aisle/geometry/sensed_segment.hpp"

namespace aisle {

/// A base line parallel to a path.
struct WallBeside {
  double lateral_m = 0;  ///< left of the path positive
  double length_m = 0;   ///< length seen
  double from_m = 0;     ///< along the path, from its start
  double to_m = 0;
  double sigma_m = 0;             ///< of `lateral_m`
  Vec2 p_vehicle = Vec2::Zero();  ///< the middle of the seen part
};

/// Finds the edges parallel to a path within 8 degrees, at least 0.2 m long.
/// @param edges            in base_link
/// @param T_path_vehicle    the vehicle in a frame with its x axis along the path
/// @param beside           replaced by the result
void find_walls_beside(std::span<const SensedSegment> edges, const Pose2& T_path_vehicle,
                       std::vector<WallBeside>& beside);

/// A base line perpendicular to a path.
struct WallAcross {
  /// From the path's start: the vehicle's position plus its distance to the wall, measured in the wall's own
  /// direction, so that the vehicle's heading does not matter.
  double along_m = 0;
  double from_m = 0;  ///< its ends beside the path, left positive
  double to_m = 0;
  double sigma_m = 0;  ///< of `along_m`
};

/// Finds the edges perpendicular to a path within 8 degrees, at least 0.2 m long.
void find_walls_across(std::span<const SensedSegment> edges, const Pose2& T_path_vehicle,
                       std::vector<WallAcross>& across);

}  // namespace aisle
