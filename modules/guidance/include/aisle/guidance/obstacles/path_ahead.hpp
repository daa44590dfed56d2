#pragma once
/// The floor that a vehicle will need on the next metres of its path.

#include <optional>
#include <vector>

#include "aisle/control/path.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// Where base_link will be.
struct Waypoint {
  double path_m = 0;  ///< from now
  Pose2 T_there_vehicle;
};

/// From now on, the nearest first.
using PathAhead = std::vector<Waypoint>;

/// The path along a path up to the end of the leg.
/// @param here  how far the vehicle has come on the path
PathAhead path_ahead(const Path& path, const PathPoint& here, const Pose2& T_map_vehicle, double reach_m);

/// How far the vehicle can go before something that stands at a point is within its footprint, or nearer to
/// its sides than a margin.
/// @return nullopt if it never is, or stands beside the vehicle or behind it already
std::optional<double> path_to(const Vec2& p_vehicle, const PathAhead& ahead, const Footprint& footprint,
                              double margin_m);

}  // namespace aisle
