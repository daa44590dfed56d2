#pragma once
/// The steering angle that keeps a vehicle to a path: C98 eq. (15), C99 eq. (8).
///
/// The papers measure the front and the rear wheels' distance from one path. On a bend that is no path for
/// both: with base_link on an arc of radius R the front reference point runs on one of radius
/// sqrt(R^2 + d^2). Here each is measured from its own path, so a vehicle that keeps to an arc has L_P = 0.

#include "aisle/control/path.hpp"
#include "aisle/core/angle.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/geometry/segment2.hpp"
#include "aisle/vehicle/command.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// Tuned on a cart of 0.75 m wheelbase at 0.3 to 1 m/s (docs/explanation/driving.md).
struct SteeringParams {
  double look_ahead_m = 0.2;              ///< S, the distance over which a steering angle is judged
  double look_ahead_s = 0.4;              ///< added to it for each m/s of speed
  double bend_ahead_m = 0;                ///< front-steered, reversing: how far before a bend the wheels turn
  double bend_ahead_s = 0.67;             ///< added to it for each m/s of speed
  double angle_step_rad = 0.1 * kDegree;  ///< of the answer

  void describe(FieldList& fields);
};

/// L_P(delta) = D_front(delta) + D_back(delta): the distances of the front and the rear wheels' middles from
/// their paths after the look-ahead with the wheels held at delta, forwards or backwards as the path is
/// driven. Before and after its leg the path is continued straight on.
/// @param from  where base_link is on the path; only its leg within reach of the look-ahead counts
double steering_cost(const FrontSteered& vehicle, const Path& path, const PathPoint& from,
                     const Pose2& T_map_vehicle, double look_ahead_m, double steering_rad);

/// Commands a vehicle along a path.
class PathFollower {
 public:
  PathFollower(const VehicleDescription& vehicle, const SteeringParams& params);

  /// The command that brings the vehicle along the path at a speed: of all steering angles that the wheels
  /// can have by the next cycle, multiples of the step, the one of least L_P (the least turn among equals,
  /// left before right). The search gives the angle that trying all of them gives. A front-steered vehicle
  /// that reverses steers as reversing.hpp says. A differential one gets the turn rate that drives the arc of
  /// a front-steered one; it turns on the spot where the path does.
  /// @param from  where the vehicle is on the path (PathProgress)
  /// @param speed_mps   of the front reference point (front-steered) or base_link (differential); >= 0, along
  ///                    the path: backwards where it is driven backwards
  /// @param steering_rad  the present steering angle; unused for a differential vehicle
  Command follow(const Path& path, const PathPoint& from, const Pose2& T_map_vehicle, double speed_mps,
                 double steering_rad) const;

  /// Turns a differential vehicle on the spot.
  /// @param due_rad  the heading to turn to
  Command turn_to(double due_rad, double heading_rad) const;

 private:
  double best_steering_rad(const FrontSteered& steered, const Path& path, const PathPoint& from,
                           const Pose2& T_map_vehicle, double look_ahead_m,
                           const Interval& allowed_rad) const;

  VehicleDescription vehicle_;
  SteeringParams params_;
};

}  // namespace aisle
