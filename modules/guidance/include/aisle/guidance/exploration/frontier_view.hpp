#pragma once

#include <cstddef>
#include <span>

#include "aisle/exploration/frontiers.hpp"
#include "aisle/maps/floor_clearance.hpp"
#include "aisle/vehicle/laser_log.hpp"

namespace aisle {

/// What the sensor could show from some pose.
struct FrontierLook {
  const LaserScanner& fan;
  std::span<const float> near_m;  ///< nearer than this a beam shows nothing, one a beam
  double reach_m = 0;             ///< farther away nothing is looked for
};

/// Whether at least `enough` points of a frontier's rim would be seen from there: within reach and within the
/// fan, with nothing between that stands or is unknown.
/// @param clearance  of the floor: free floor is passed in strides
bool sees_rim(const FrontierLook& look, const FloorGrid& floor, const FloorClearance& clearance,
              const Pose2& T_map_vehicle, const Frontier& frontier, std::size_t enough);

}  // namespace aisle
