#include "aisle/control/reversing.hpp"

#include <algorithm>
#include <cmath>

#include "aisle/core/angle.hpp"
#include "aisle/vehicle/gear.hpp"

namespace aisle {
namespace {

constexpr double kSettle_m = 0.35;  // distance over which an error shrinks to 1/e

/// Curvature of the path a little ahead, on the same leg.
double curvature_ahead_per_m(const Path& path, const PathPoint& point, double ahead_m) {
  return path.at(std::min(point.along_m + ahead_m, path.leg_end_m(point.piece) - 1e-6)).curvature_per_m;
}

}  // namespace

/// With e how far base_link is to the left of the path, h its heading relative to the path's, s the distance
/// (against the heading: e' = -sin h, h' = -(curvature - path's curvature)): e'' = -2 e' / S - e / S^2
/// settles without overshoot.
double reversing_steering_rad(const VehicleDescription& vehicle, const Path& path, const PathPoint& point,
                              const Pose2& T_map_vehicle, double ahead_m, double steering_rad) {
  const Pose2 off = between(point.T_map_path, T_map_vehicle);
  const Gear gear = gear_of(path.pieces()[point.piece].arc.length_m);
  const double bend_per_m = curvature_ahead_per_m(path, point, ahead_m) -
                            sign(gear) * 2 * std::sin(off.theta) / kSettle_m -
                            off.y / (kSettle_m * kSettle_m);
  const double wanted_rad = std::atan(bend_per_m * vehicle.front_steered.wheelbase_m);
  const double change_rad = vehicle.limits.steering_rate_max_rad_s * vehicle.cycle_s;
  const double max_rad = vehicle.limits.steering_max_rad;
  return std::clamp(std::clamp(wanted_rad, steering_rad - change_rad, steering_rad + change_rad), -max_rad,
                    max_rad);
}

}  // namespace aisle
