#pragma once

#include <cstddef>
#include <span>

#include "aisle/exploration/frontiers.hpp"
#include "aisle/maps/known_floor.hpp"
#include "aisle/vehicle/laser_log.hpp"

namespace aisle {

/// What the scan source can show from some pose.
struct FrontierLook {
  const LaserScanner& scanner;
  std::span<const float> near_m;  ///< one per beam: it shows nothing nearer than this; empty: no limit
  double reach_m = 0;             ///< points farther away do not count
};

/// Whether at least `enough` points of a frontier's edge would be seen from there: within reach, inside the
/// scan's field of view, and with neither obstacles nor unknown floor in between.
bool sees_frontier(const FrontierLook& look, const KnownFloor& floor, const Pose2& T_map_vehicle,
                   const Frontier& frontier, std::size_t enough);

}  // namespace aisle
