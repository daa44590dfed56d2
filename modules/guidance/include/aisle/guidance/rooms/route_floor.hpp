#pragma once

#include <span>
#include <vector>

#include "aisle/control/path.hpp"
#include "aisle/maps/floor_grid.hpp"
#include "aisle/maps/room_route.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// Makes the floor under a footprint free.
void free_under(const Footprint& footprint, const Pose2& T_floor_vehicle, FloorGrid& floor);

/// The floor that a path was taught on, about a place: free where the vehicle drove, and where it saw an edge
/// of the route over it; edges are occupied; of all else nothing is known.
/// @param edges       in the frame of the path, as is the floor
/// @param p_map_place the floor within `reach_m` of it
FloorGrid route_floor(const Path& path, std::span<const RouteEdge> edges, const Footprint& footprint,
                      const Vec2& p_map_place, double reach_m);

/// How much of a taught path has edges of the route where the vehicle then drove, as a share of its length:
/// there a pattern on the floor was taken for something that stands.
double share_with_edges_on_path(const Path& path, std::span<const RouteEdge> edges,
                                const Footprint& footprint);

/// Where what is known of a floor ends: the middles of the cells next to free ones of which nothing is known.
std::vector<Vec2> limit_of_known(const FloorGrid& floor);

}  // namespace aisle
