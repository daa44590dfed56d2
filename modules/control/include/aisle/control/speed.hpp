#pragma once

#include "aisle/control/path.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

struct SpeedParams {
  double speed_mps = 0.3;                       ///< where nothing limits it
  double speed_min_mps = 0.05;                  ///< least speed while driving
  double sideways_acceleration_max_mps2 = 0.4;  ///< in bends
  double deceleration_mps2 = 0.3;               ///< towards bends and the end

  void describe(FieldList& fields);
};

/// The greatest speed at a point of a path from which the vehicle still takes the bends ahead gently, stops
/// at the path's end (and at direction changes), and keeps its own limits [m/s].
/// @param certainty  of the vehicle's pose, 0 .. 1; less means slower, down to `speed_min_mps`
double speed_along(const Path& path, double along_m, double certainty, const VehicleDescription& vehicle,
                   const SpeedParams& params);

}  // namespace aisle
