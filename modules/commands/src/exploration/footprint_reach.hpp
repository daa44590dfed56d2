#pragma once

#include <span>
#include <vector>

#include "aisle/geometry/segment2.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// Where a vehicle can get to from its start, by the truth: forwards and backwards along arcs that its wheels
/// can drive, its whole footprint and a margin off all obstacles.
/// @param obstacles  at least one
/// @return a pose for every 0.4 m and 45 degrees that are reached; the first is the start, whatever stands
/// there
std::vector<Pose2> poses_in_reach(std::span<const Segment2> obstacles, const VehicleDescription& vehicle,
                                  const Pose2& T_world_start, double margin_m);

}  // namespace aisle
