#pragma once

#include <span>
#include <vector>

#include "aisle/control/path.hpp"
#include "aisle/maps/floor_grid.hpp"
#include "aisle/maps/room_route.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// Marks the floor under a footprint as free.
void free_under(const Footprint& footprint, const Pose2& T_floor_vehicle, FloorGrid& floor);

/// The floor near a place of a taught path: free where the vehicle drove and along its lines of sight to the
/// route's edges; occupied at the edges; unknown elsewhere.
/// @param edges        in the frame of the path, as is the floor
/// @param p_map_place  the floor covers at least `reach_m` around it
FloorGrid route_floor(const Path& path, std::span<const RouteEdge> edges, const Footprint& footprint,
                      const Vec2& p_map_place, double reach_m);

/// Share of a taught path's length where edges were seen and the vehicle then drove over them: there a
/// pattern on the floor looked like an obstacle.
double share_with_edges_on_path(const Path& path, std::span<const RouteEdge> edges,
                                const Footprint& footprint);

/// The limit of the known floor: centres of unknown cells next to free ones.
std::vector<Vec2> limit_of_known(const FloorGrid& floor);

}  // namespace aisle
