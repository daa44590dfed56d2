#pragma once

#include <span>

#include "aisle/maps/barrier.hpp"
#include "aisle/vehicle/command.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// The barrier that a vehicle would meet if it executed the command and then braked; nullptr: none.
const Barrier* barrier_ahead(std::span<const Barrier> barriers, const VehicleDescription& vehicle,
                             const Pose2& T_map_vehicle, const Command& command);

}  // namespace aisle
