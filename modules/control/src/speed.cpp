#include "aisle/control/speed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace aisle {
namespace {

/// The greatest speed at which the vehicle can drive a piece, and may by `params`.
double speed_on_mps(const PathPiece& piece, const VehicleDescription& vehicle, const SpeedParams& params) {
  const DriveLimits& limits = vehicle.limits;
  const double curvature_per_m = std::abs(piece.curvature_per_m());
  double possible_mps = piece.arc.length_m < 0 ? limits.reverse_speed_max_mps : limits.speed_max_mps;
  if (vehicle.is_differential && curvature_per_m > 0) {
    possible_mps = std::min(possible_mps, limits.turn_rate_max_rad_s / curvature_per_m);
  }
  const double gentle_mps = curvature_per_m > 0
                                ? std::sqrt(params.sideways_acceleration_max_mps2 / curvature_per_m)
                                : std::numeric_limits<double>::infinity();
  return std::min({possible_mps, params.speed_mps, std::max(gentle_mps, params.speed_min_mps)});
}

}  // namespace

void SpeedParams::describe(FieldList& fields) {
  fields.real("speed_mps", speed_mps, {0.01, 5}, "where nothing limits it");
  fields.real("speed_min_mps", speed_min_mps, {0.005, 1}, "least speed while driving");
  fields.real("sideways_acceleration_max_mps2", sideways_acceleration_max_mps2, {0.01, 10}, "in bends");
  fields.real("deceleration_mps2", deceleration_mps2, {0.01, 10}, "towards bends and the end");
}

double speed_along(const Path& path, double along_m, double certainty, const VehicleDescription& vehicle,
                   const SpeedParams& params) {
  if (path.empty() || along_m >= path.length_m()) return 0;
  const double deceleration_mps2 = std::min(params.deceleration_mps2, vehicle.limits.deceleration_max_mps2);
  const double late_mps = deceleration_mps2 * vehicle.cycle_s;
  // The speed now that becomes `later_mps` after the distance if braking begins a cycle from now.
  const auto before_mps = [&](double later_mps, double distance_m) {
    const double squared = late_mps * late_mps + later_mps * later_mps + 2 * deceleration_mps2 * distance_m;
    return std::max(later_mps, std::sqrt(squared) - late_mps);
  };
  const PathPoint here = path.at(along_m);
  const std::size_t leg_end = path.leg_end(here.piece);
  const double here_mps = speed_on_mps(path.pieces()[here.piece], vehicle, params);

  double braking_mps = std::numeric_limits<double>::infinity();
  for (std::size_t i = here.piece + 1; i < leg_end; ++i) {
    const double distance_m = path.start_m(i) - here.along_m;
    braking_mps =
        std::min(braking_mps, before_mps(speed_on_mps(path.pieces()[i], vehicle, params), distance_m));
  }
  const double to_stop_m = path.leg_end_m(here.piece) - here.along_m;
  braking_mps = std::min(braking_mps, before_mps(0, to_stop_m));

  const double sure_mps = params.speed_mps * std::clamp(certainty, 0.0, 1.0);
  return std::min(here_mps, std::max(params.speed_min_mps, std::min(braking_mps, sure_mps)));
}

}  // namespace aisle
