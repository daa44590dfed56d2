#pragma once

#include <cmath>

#include "aisle/core/angle.hpp"
#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// How far the vehicle has moved since an image, by its odometry. After too much motion the view differs
/// anyway, and comparing another image with that one tells nothing.
class MotionSince {
 public:
  /// The reference image is taken now.
  void start() { *this = {}; }

  void move(const Pose2& T_before_now) {
    travelled_m_ += T_before_now.position().norm();
    turn_rad_ += T_before_now.theta;
    T_then_now_ = T_then_now_ * T_before_now;
  }

  const Pose2& T_then_now() const { return T_then_now_; }

  bool is_comparable() const {
    return travelled_m_ < kComparedPath_m && std::abs(turn_rad_) < kComparedTurn_rad;
  }

 private:
  static constexpr double kComparedPath_m = 0.5;
  static constexpr double kComparedTurn_rad = 10 * kDegree;

  double travelled_m_ = 0;
  double turn_rad_ = 0;
  Pose2 T_then_now_;
};

}  // namespace aisle
