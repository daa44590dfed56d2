#pragma once

#include "aisle/vehicle/front_steered.hpp"

namespace aisle {

/// Undoes what a front-steered vehicle's odometer and steering encoder misreport, of every motion alike.
struct OdometryCorrection {
  double distance_factor = 1;    ///< real distance per reported one
  double steering_bias_rad = 0;  ///< how much farther left than reported the front wheels point

  /// The motion that took place.
  FrontSteeredMotion corrected(const FrontSteeredMotion& reported) const {
    return {distance_factor * reported.distance_m, reported.steering_rad + steering_bias_rad};
  }

  friend bool operator==(const OdometryCorrection&, const OdometryCorrection&) = default;
};

}  // namespace aisle
