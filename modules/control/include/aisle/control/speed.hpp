#pragma once

#include "aisle/control/path.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

struct SpeedParams {
  double speed_mps = 0.3;       ///< where nothing speaks against it
  double speed_min_mps = 0.05;  ///< of a vehicle that goes at all
  double sideways_acceleration_max_mps2 = 0.4;
  double deceleration_mps2 = 0.3;  ///< towards bends and the end

  void describe(FieldList& fields);
};

/// The greatest speed at a point of a path from which the vehicle still takes the bends ahead gently, stops
/// at the path's end (and where the path turns back), and keeps its own limits.
/// @param certainty  0 .. 1: how sure the vehicle is of where it is; less means slower, down to the least
/// speed
double speed_along(const Path& path, double along_m, double certainty, const VehicleDescription& vehicle,
                   const SpeedParams& params);

}  // namespace aisle
