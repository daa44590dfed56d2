#pragma once

#include <span>

#include "aisle/maps/floor_grid.hpp"
#include "aisle/vehicle/laser_log.hpp"

namespace aisle {

/// The floor as the scans of a log show it: free up to their hits, occupied there, unknown elsewhere. Scans
/// that are taken where the last one was add nothing and are left out. What has walked away fades.
/// @param T_map_vehicle  one per scan
FloorGrid floor_of_log(const LaserLog& log, std::span<const Pose2> T_map_vehicle);

}  // namespace aisle
