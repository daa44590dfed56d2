#pragma once
/// The floor that a vehicle will need on the next metres of its path.

#include <optional>
#include <vector>

#include "aisle/control/path.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// A future pose of base_link.
struct Waypoint {
  double path_m = 0;  ///< distance from the present pose
  Pose2 T_there_vehicle;
};

/// Future poses, the nearest first.
using PathAhead = std::vector<Waypoint>;

/// Poses along a path, up to the end of its present leg or `reach_m`.
/// @param here  the vehicle's progress on the path
PathAhead path_ahead(const Path& path, const PathPoint& here, const Pose2& T_map_vehicle, double reach_m);

/// How far the vehicle can go before a point is inside its footprint, or nearer to its sides than a margin.
/// @return nullopt if it never is, or if the point lies beside the vehicle or behind it already
std::optional<double> path_to(const Vec2& p_vehicle, const PathAhead& ahead, const Footprint& footprint,
                              double margin_m);

}  // namespace aisle
