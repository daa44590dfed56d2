#pragma once

#include <optional>
#include <vector>

#include "aisle/core/progress.hpp"
#include "aisle/simulation/world.hpp"

namespace aisle {

struct RoundTripParams {
  double vehicle_width_m = 0.6;
  double margin_m = 0.02;  ///< that stays free on either side
  double reach_m = 2;      ///< how near the run comes to every place where the vehicle can be
  double height_m = 2;     ///< what stands below it is in the path
};

/// A path through everything that can be reached, out into every branch and back to where it began.
struct RoundTrip {
  Pose2 T_world_start;     ///< at the first waypoint, facing the second
  std::vector<Vec2> tour;  ///< begins and ends at the start; its legs keep half the width and the margin free
  double drivable_m2 = 0;  ///< where the vehicle's centre can be
};

/// The run through the largest area that such a vehicle can drive in: a tree of cheapest paths that prefer
/// the middle of the free space, walked depth first. It begins at the start of the world if that is in this
/// area. No value if there is no room for the vehicle.
std::optional<RoundTrip> plan_round_trip(const World& world, const RoundTripParams& params,
                                         Progress& progress);

}  // namespace aisle
