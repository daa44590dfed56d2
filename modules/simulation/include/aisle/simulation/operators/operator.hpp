#pragma once

#include "aisle/geometry/pose2.hpp"
#include "aisle/vehicle/observation.hpp"

namespace aisle {

/// What a person walking beside the vehicle sees of it.
struct OperatorView {
  double stamp_s = 0;
  Pose2 T_world_vehicle;
  double speed_mps = 0;  ///< of base_link, forwards
  double turn_rate_rad_s = 0;
  /// Free distance along its present arc [m], with some clearance to people; at most kSeenAhead_m.
  double free_ahead_m = 0;
  bool bumper_pressed = false;
};

/// How far an operator looks ahead along the vehicle's path.
inline constexpr double kSeenAhead_m = 2;

/// Drives a simulated vehicle by hand.
class Operator {
 public:
  virtual ~Operator() = default;

  /// Asked once a cycle, at its end.
  virtual OperatorInput look(const OperatorView& view) = 0;
};

}  // namespace aisle
