#pragma once

#include <span>

#include "aisle/maps/floor_grid.hpp"
#include "aisle/vehicle/laser_log.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// How a fan of ranges tells free floor. Between two beams the floor counts as free as far as the nearer of
/// both goes. A scanner's beams that strike nothing have lost their light, and tell nothing, where others
/// beside them leave no opening in which anything could drive.
struct FloorViewParams {
  double reach_m = 6;  ///< farther floor is left unknown

  void describe(FieldList& fields);
};

/// Puts what one scan shows onto the floor: free up to what each beam strikes, occupied there.
/// @param near_m  one a beam: what is nearer was not looked at, and a beam that strikes nothing tells of free
///                floor only where nothing is known to stand nearer; empty: everything was looked at
/// @return the cells that are something else now lie in this box
FloorBox see_floor(FloorGrid& floor, const LaserScanner& laser, std::span<const float> ranges_m,
                   std::span<const float> near_m, const Pose2& T_map_vehicle, const FloorViewParams& params);

/// Floor on which the vehicle stands is free, and nothing is above it.
/// @return the cells of which more is known now lie in this box
FloorBox stand_on_floor(FloorGrid& floor, const Footprint& footprint, const Pose2& T_map_vehicle);

/// What the vehicle has touched stands right before its front (1), or behind its rear (-1): occupied there.
FloorBox strike_floor(FloorGrid& floor, const Footprint& footprint, const Pose2& T_map_vehicle,
                      int direction);

}  // namespace aisle
