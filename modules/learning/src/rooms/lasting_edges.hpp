#pragma once

#include <span>
#include <vector>

#include "aisle/learning/rooms/room_learning.hpp"

namespace aisle {

/// The route edges that several images showed at the same place, in the order of the path.
/// @param T_route_vehicle  of each cycle
std::vector<RouteEdge> lasting_edges(std::span<const RoomCycle> cycles,
                                     std::span<const Pose2> T_route_vehicle,
                                     const RoomLearningParams& params);

}  // namespace aisle
