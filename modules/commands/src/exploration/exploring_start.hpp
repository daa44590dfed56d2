#pragma once

#include "aisle/simulation/world.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// Where a vehicle is set down in a plan that tells no start: as given if a path lies ahead that is long
/// enough to turn in, else turned on the spot, else on the next point of the world's tour that has such a
/// path. Nobody sets one down facing a corner. As given, too, if there is none at all.
Pose2 start_with_a_path(const World& world, const Footprint& footprint, const Pose2& T_world_start);

}  // namespace aisle
