#pragma once
/// Keeping a front-steered vehicle to a path that it drives backwards.
///
/// Backwards, base_link goes first, and laying both wheels on the path after a look-ahead (steering.hpp)
/// needs so long a look-ahead that bends are cut. Here the bend itself brings base_link's distance from the
/// path and its heading off it to 0, without overshoot, whichever path it drives.

#include "aisle/control/path.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// So far before a bend the wheels begin to turn where the room about the path is judged by the wheels as
/// they stand: turned long before it they would stand across that room.
inline constexpr double kLateBendAhead_m = 0.04;

/// The steering angle that the wheels shall have, within what they can have by the next cycle.
/// @param point  where the vehicle is on the path, which must not be on the spot
/// @param ahead_m  so far before a bend they begin to turn for it
/// @param steering_rad  how the wheels stand now
double reversing_steering_rad(const VehicleDescription& vehicle, const Path& path, const PathPoint& point,
                              const Pose2& T_map_vehicle, double ahead_m, double steering_rad);

}  // namespace aisle
