#pragma once
/// Keeping a front-steered vehicle to a path that it drives backwards.
///
/// Backwards, base_link goes first, and laying both wheels on the path after a look-ahead (steering.hpp)
/// needs so long a look-ahead that bends are cut. Here the steering law itself brings base_link's cross-track
/// error and heading error to 0 without overshoot.

#include "aisle/control/path.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// How far before a bend the wheels begin to turn where the clearance about the path is checked for the
/// present steering angle: wheels turned long before the bend would predict a motion out of that clearance.
inline constexpr double kLateBendAhead_m = 0.04;

/// The steering angle to command, within what the wheels can reach by the next cycle [rad, left positive].
/// @param point  where the vehicle is on the path, which must not be on the spot
/// @param ahead_m  how far before a bend the wheels begin to turn for it
/// @param steering_rad  the present steering angle
double reversing_steering_rad(const VehicleDescription& vehicle, const Path& path, const PathPoint& point,
                              const Pose2& T_map_vehicle, double ahead_m, double steering_rad);

}  // namespace aisle
