#pragma once

#include <span>
#include <vector>

#include "aisle/geometry/segment2.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// The poses that a vehicle can truly reach from its start, forwards and backwards along arcs that its wheels
/// can drive, with its whole footprint and a margin clear of all obstacles.
/// @param obstacles  at least one
/// @return one pose per reached cell of 0.4 m and 45 degrees; the first is the start, even if it is occupied
std::vector<Pose2> poses_in_reach(std::span<const Segment2> obstacles, const VehicleDescription& vehicle,
                                  const Pose2& T_world_start, double margin_m);

}  // namespace aisle
