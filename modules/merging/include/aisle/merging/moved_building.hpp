#pragma once

#include "aisle/maps/building.hpp"

namespace aisle {

/// The same building in another frame: everything that lies in its `map` is moved. Floor cells are taken as
/// they lie on the new frame's grid; no occupied one is lost.
/// @param T_to_map  pose of the building's frame in the new one
Building moved_building(const Building& building, const Pose2& T_to_map);

/// Floor cells in another frame, as above.
FloorGrid moved_floor(const FloorGrid& floor, const Pose2& T_to_map);

}  // namespace aisle
