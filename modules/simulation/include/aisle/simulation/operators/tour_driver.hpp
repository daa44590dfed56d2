#pragma once

#include <vector>

#include "aisle/core/angle.hpp"
#include "aisle/core/parameters.hpp"
#include "aisle/geometry/pose2.hpp"
#include "aisle/vehicle/arc.hpp"

namespace aisle {

/// How a differential vehicle follows a tour.
struct TourDriverParams {
  double speed_max_mps = 0.5;
  double acceleration_max_mps2 = 0.5;
  double turn_rate_max_rad_s = 45 * kDegree;
  double look_ahead_m = 0.5;

  void describe(FieldList& fields) {
    fields.real("speed_max_mps", speed_max_mps, {0.01, 0.5}, "speed on a straight segment");
    fields.real("acceleration_max_mps2", acceleration_max_mps2, {0.05, 5}, "change of speed");
    fields.angle("turn_rate_max_deg_s", turn_rate_max_rad_s, {5, 180}, "turning on the spot and in corners");
    fields.real("look_ahead_m", look_ahead_m, {0.1, 2}, "how much of each corner is cut to a smooth turn");
  }
};

/// Follows a look-ahead point (the carrot) that runs along the tour ahead of the vehicle: corners come out
/// rounded, and where the tour turns back on itself the vehicle turns around in little space.
class TourDriver {
 public:
  /// Starts at the first of at least two different waypoints, facing the next.
  /// @throws std::invalid_argument if there are fewer
  TourDriver(std::vector<Vec2> tour, const TourDriverParams& params);

  bool has_arrived() const;
  /// Waypoints that the vehicle has passed; consecutive ones at the same place count once.
  std::size_t waypoints_passed() const { return next_ - 1; }
  std::size_t waypoints() const { return tour_.size(); }
  /// The true pose in `world`.
  const Pose2& pose() const { return T_world_vehicle_; }

  /// Drives on for `time_s`. @return the arc driven
  Arc step(double time_s);

 private:
  void advance_carrot();

  TourDriverParams params_;
  std::vector<Vec2> tour_;
  std::size_t next_ = 1;  ///< the waypoint that the carrot runs to
  Vec2 carrot_;
  Pose2 T_world_vehicle_;
  double speed_mps_ = 0;
};

}  // namespace aisle
