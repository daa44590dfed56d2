#pragma once

#include <span>
#include <vector>

#include "aisle/learning/rooms/room_learning.hpp"

namespace aisle {

/// Picks, from the images taken around a taught place after the path to it, those at the places of its
/// pattern (maps/view_pattern.hpp).
/// @return none if less than a third of the pattern was driven
std::vector<StopView> pattern_views(std::span<const RoomCycle> cycles, std::span<const Pose2> T_route_vehicle,
                                    const Pose2& T_route_place);

}  // namespace aisle
