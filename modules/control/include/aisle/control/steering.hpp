#pragma once
/// Which way to hold the wheels: C98 eq. (15), C99 eq. (8).

#include "aisle/control/path.hpp"
#include "aisle/core/angle.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/vehicle/command.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

struct SteeringParams {
  double look_ahead_m = 0.6;               ///< S, the way over which a steering angle is judged
  double look_ahead_s = 0.8;               ///< as much more at speed
  double angle_step_rad = 0.1 * kDegree;   ///< of the answer

  void describe(FieldList& fields);
};

/// L_P(delta) = D_front(delta) + D_back(delta): the distances of the front and the rear wheels' middles from the
/// path after the look-ahead with the wheels held at delta, forwards or backwards.
/// @param from  where base_link is on the path, roughly: only the path within reach of the look-ahead counts
double steering_cost(const FrontSteered& vehicle, const Path& path, const PathPoint& from,
                     const Pose2& T_map_vehicle, double look_ahead_m, double steering_rad);

/// Keeps to a path.
class PathFollower {
 public:
  PathFollower(const VehicleDescription& vehicle, const SteeringParams& params);

  /// The command that brings the vehicle along the path at a speed: of all steering angles that the wheels can
  /// have by the next cycle, multiples of the step, the one of least L_P (the least turn among equals). The
  /// search gives the angle that trying all of them gives. A differential vehicle gets the turn rate that drives
  /// the same arc.
  /// @param speed_mps   of the front reference point (front-steered) or base_link (differential); >= 0, along
  ///                    the path: backwards where it is driven backwards
  /// @param steering_rad  how the wheels stand now; unused for a differential vehicle
  Command follow(const Path& path, const PathPoint& from, const Pose2& T_map_vehicle, double speed_mps,
                 double steering_rad) const;

 private:
  VehicleDescription vehicle_;
  SteeringParams params_;
};

}  // namespace aisle
