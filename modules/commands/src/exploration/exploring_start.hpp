#pragma once

#include "aisle/simulation/world.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// Initial pose in a plan without a start, since nobody puts a vehicle down facing a corner: the given pose
/// if a path ahead is long enough to turn in; else the same point with another heading; else the next point
/// of the world's tour that has such a path. The given pose if there is none at all.
Pose2 start_with_a_path(const World& world, const Footprint& footprint, const Pose2& T_world_start);

}  // namespace aisle
