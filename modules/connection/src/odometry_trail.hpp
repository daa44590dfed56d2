#pragma once

#include <vector>

#include "aisle/vehicle/laser_log.hpp"

namespace aisle {

/// Where the odometry says the vehicle was, as a function of time. Leaps of it are left out: the trail is the
/// motion alone.
class OdometryTrail {
 public:
  enum class Taken {
    kMotion,
    kOutOfOrder,  ///< not newer than the one before; not taken
    kLeap,        ///< farther away than a vehicle gets; no motion
    kRestart      ///< a leap to where odometry begins to count; no motion
  };

  /// @param leap_m  what one message may add to the distance that the speed allows
  OdometryTrail(double leap_m, double speed_max_mps) : leap_m_(leap_m), speed_max_mps_(speed_max_mps) {}

  Taken take(double stamp_s, const Pose2& T_odom_vehicle);

  bool empty() const { return samples_.empty(); }
  double newest_s() const { return samples_.back().time_s; }

  /// Interpolated, and carried on for a while after the newest sample: see OdometryTrack.
  Pose2 at(double stamp_s) const;
  /// A pose of the trail, where the odometry has it since its last leap.
  Pose2 in_odom(const Pose2& T_trail) const { return T_trail_odom_.inverse() * T_trail; }

 private:
  void keep(double stamp_s, const Pose2& T_odom_vehicle);

  double leap_m_;
  double speed_max_mps_;
  std::vector<OdometrySample> samples_;  ///< where the trail is, by stamp
  Pose2 T_trail_odom_;
  Pose2 T_odom_newest_;
};

}  // namespace aisle
