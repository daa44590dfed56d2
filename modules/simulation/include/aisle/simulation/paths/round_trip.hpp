#pragma once

#include <optional>
#include <vector>

#include "aisle/core/progress.hpp"
#include "aisle/simulation/world.hpp"

namespace aisle {

struct RoundTripParams {
  double vehicle_width_m = 0.6;
  double margin_m = 0.02;  ///< clearance on either side
  double reach_m = 2;      ///< how near the tour comes to every place that the vehicle can reach
  double height_m = 2;     ///< obstacles below it count
};

/// Floor on which a vehicle fits, but which it cannot reach.
struct ShutOffFloor {
  double share = 0;  ///< of all floor on which it fits
  double largest_m2 = 0;
  Vec2 p_world_largest = Vec2::Zero();  ///< a place in the largest part, far from walls
};

/// A tour through all reachable floor, out into every branch and back to the start.
struct RoundTrip {
  Pose2 T_world_start;     ///< at the first waypoint, facing the second
  std::vector<Vec2> tour;  ///< from the start to the start; keeps half the width and the margin clear
  double drivable_m2 = 0;  ///< where the vehicle's centre can be
  std::optional<ShutOffFloor> shut_off;
};

/// The tour through the largest area that such a vehicle can drive in: a tree of cheapest paths that prefer
/// the middle of the free space, traversed depth first. It begins at the start of the world if that is in
/// this area. No value if the vehicle fits nowhere.
std::optional<RoundTrip> plan_round_trip(const World& world, const RoundTripParams& params,
                                         Progress& progress);

}  // namespace aisle
