#pragma once

#include <span>

#include "aisle/formats/images/map_server.hpp"
#include "aisle/maps/floor_grid.hpp"
#include "aisle/maps/wall_map.hpp"
#include "aisle/vehicle/laser_log.hpp"

namespace aisle {

/// The map as an occupancy grid: free where beams of the log passed, occupied along the walls and where the
/// floor is (furniture, clutter), unknown elsewhere. Cells are 5 cm wide, or wider if needed to stay below
/// `cells_max`.
OccupancyImage occupancy_of(const WallMap& walls, const FloorGrid& floor, const LaserLog& log,
                            std::span<const Pose2> T_map_vehicle, double cells_max = 64e6);

}  // namespace aisle
