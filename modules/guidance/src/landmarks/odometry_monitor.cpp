#include "aisle/guidance/landmarks/odometry_monitor.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace aisle {
namespace {

constexpr double kCompared_m = 1.5;     // path that counts: wheels may slip for less
constexpr double kComparedMin_m = 1.0;  // of it, before the two can be told apart
constexpr double kJump_m = 0.8;         // a difference this large at once: the vehicle was lifted
constexpr double kOffMax = 1.6;         // between them; a slip of 0.8 m by half its length makes 1.3

}  // namespace

void OdometryMonitor::look(const Pose2& T_odom_vehicle, const Pose2& T_map_vehicle) {
  const auto before = std::exchange(last_, Poses{T_odom_vehicle, T_map_vehicle});
  if (!before) return;
  const double counted_m = between(before->T_odom_vehicle, T_odom_vehicle).x;
  const double shown_m = between(before->T_map_vehicle, T_map_vehicle).x;
  const double kept = std::exp(-(std::abs(counted_m) + std::abs(shown_m)) / 2 / kCompared_m);
  const double forward = std::copysign(1, counted_m);
  counted_m_ = kept * counted_m_ + forward * counted_m;
  shown_m_ = kept * shown_m_ + forward * shown_m;
}

void OdometryMonitor::relocalise(const Pose2& T_odom_vehicle, const Pose2& T_map_vehicle) {
  const bool was_kidnapped = !last_ || std::abs(between(last_->T_odom_vehicle, T_odom_vehicle).x -
                                                between(last_->T_map_vehicle, T_map_vehicle).x) > kJump_m;
  if (!was_kidnapped) return look(T_odom_vehicle, T_map_vehicle);
  last_ = Poses{T_odom_vehicle, T_map_vehicle};
  counted_m_ = shown_m_ = 0;
}

std::optional<double> OdometryMonitor::off_by() const {
  if (std::max(counted_m_, shown_m_) < kComparedMin_m) return std::nullopt;
  const double off_by = counted_m_ / std::max(shown_m_, 0.1 * counted_m_);
  return off_by > kOffMax || off_by < 1 / kOffMax ? std::optional(off_by) : std::nullopt;
}

}  // namespace aisle
