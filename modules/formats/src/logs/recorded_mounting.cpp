#include "logs/recorded_mounting.hpp"

#include <cmath>

#include "aisle/core/angle.hpp"

namespace aisle {

void RecordedMounting::add(const Pose2& T_odom_vehicle, const Pose2& T_odom_laser) {
  const Pose2 T_vehicle_laser = between(T_odom_vehicle, T_odom_laser);
  if (!first_) first_ = T_vehicle_laser;
  const Pose2 change = between(*first_, T_vehicle_laser);
  all_agree_ = all_agree_ && change.position().norm() < 0.01 && std::abs(change.theta) < 0.5 * kDegree;
}

bool is_off_origin(const Pose2& T_vehicle_laser) {
  constexpr double kRounding = 1e-6;
  return T_vehicle_laser.position().norm() > kRounding || std::abs(T_vehicle_laser.theta) > kRounding;
}

}  // namespace aisle
