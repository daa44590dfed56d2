#pragma once

#include <span>

#include "aisle/maps/floor_grid.hpp"
#include "aisle/vehicle/gear.hpp"
#include "aisle/vehicle/laser_log.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// How a scan shows free floor. Between two beams the floor counts as free up to the nearer of the two. Beams
/// without a return are ignored where their neighbours leave no opening wide enough to drive through: dark or
/// shiny surfaces absorb them. Elsewhere they show free floor up to what is known to stand there.
struct FloorViewParams {
  double reach_m = 6;  ///< farther floor is left unknown

  void describe(FieldList& fields);
};

/// Whether a scan sees the floor from where the one before it did. Then its beams pass what the others
/// passed, and miss what these missed.
enum class Viewpoint { kMoved, kSame };

/// Enters a scan into the floor: free up to each hit, occupied there.
/// @param near_m  one a beam [m]: nothing nearer was looked at, and a beam without a return shows free floor
///                only where nothing nearer is known; empty: everything was looked at
/// @return a box around all cells that have changed
FloorBox see_floor(FloorGrid& floor, const LaserScanner& laser, std::span<const float> ranges_m,
                   std::span<const float> near_m, const Pose2& T_map_vehicle, const FloorViewParams& params,
                   Viewpoint viewpoint = Viewpoint::kSame);

/// Floor under the vehicle is free, and nothing is above it.
/// @return a box around all cells about which more is known now
FloorBox stand_on_floor(FloorGrid& floor, const Footprint& footprint, const Pose2& T_map_vehicle);

/// Bumper contact: floor right in front of the vehicle or, in reverse, behind it is occupied.
/// @return a box around all cells that have changed
FloorBox strike_floor(FloorGrid& floor, const Footprint& footprint, const Pose2& T_map_vehicle, Gear gear);

}  // namespace aisle
