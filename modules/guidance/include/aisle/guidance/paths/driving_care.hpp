#pragma once

#include "aisle/guidance/paths/footprint_clearance.hpp"

namespace aisle {

/// The share of its speed at which a vehicle follows its path accurately enough: less where there is little
/// clearance, and where the wheels have yet to turn.
/// @param along_m       where it is on the path
/// @param steering_rad  present steering angle
/// @return from 0.3 to 1
double driving_care(const VehicleDescription& vehicle, const FootprintClearance& footprint_clearance,
                    const KnownFloor& floor, const Path& path, double along_m, double steering_rad);

}  // namespace aisle
