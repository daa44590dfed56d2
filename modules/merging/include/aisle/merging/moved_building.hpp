#pragma once

#include <optional>

#include "aisle/maps/building.hpp"

namespace aisle {

/// The same building in another frame: everything that lies in its `map` is moved. Floor cells are taken as
/// they lie on the new frame's grid; no occupied one is lost.
/// @param T_to_map  pose of the building's frame in the new one
/// @param cell_m  width of the floor's cells there: grids can be compared only if they have the same; none:
/// as before
Building moved_building(const Building& building, const Pose2& T_to_map,
                        std::optional<double> cell_m = std::nullopt);

/// Floor cells in another frame, as above.
FloorGrid moved_floor(const FloorGrid& floor, const Pose2& T_to_map, double cell_m);

}  // namespace aisle
