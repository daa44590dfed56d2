#pragma once

#include "driver.hpp"
#include "physics.hpp"

namespace robots {

/// Adds up how the driven wheels have turned, from `odom` at the start. It knows nothing of slip.
class WheelOdometry {
 public:
  explicit WheelOdometry(const Calibration& calibration) : calibration_(calibration) {}

  void advance(const JointReading& left, const JointReading& right) {
    const double left_m = (left.angle_rad - left_rad_) * calibration_.left_radius_m;
    const double right_m = (right.angle_rad - right_rad_) * calibration_.right_radius_m;
    const double turn_rad = (right_m - left_m) / calibration_.separation_m;
    const Pose2 half_turn{0, 0, turn_rad / 2};
    T_odom_vehicle_ = T_odom_vehicle_ * half_turn * Pose2{(left_m + right_m) / 2, 0, 0} * half_turn;
    left_rad_ = left.angle_rad;
    right_rad_ = right.angle_rad;
    const double left_mps = left.rate_radps * calibration_.left_radius_m;
    const double right_mps = right.rate_radps * calibration_.right_radius_m;
    speed_mps_ = (left_mps + right_mps) / 2;
    turn_rate_radps_ = (right_mps - left_mps) / calibration_.separation_m;
  }

  const Pose2& T_odom_vehicle() const { return T_odom_vehicle_; }
  double speed_mps() const { return speed_mps_; }
  double turn_rate_radps() const { return turn_rate_radps_; }

 private:
  Calibration calibration_;
  double left_rad_ = 0, right_rad_ = 0;
  Pose2 T_odom_vehicle_;
  double speed_mps_ = 0, turn_rate_radps_ = 0;
};

}  // namespace robots
