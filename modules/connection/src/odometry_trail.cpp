#include "odometry_trail.hpp"

#include <algorithm>

#include "aisle/vehicle/odometry_track.hpp"

namespace aisle {
namespace {

constexpr std::size_t kSamplesMax = 2000;  // 10 s of the fastest odometry
constexpr double kFaster = 2;              // than the vehicle's limit: a robot may be pushed, or downhill
constexpr double kGapMax_s = 1;            // a longer gap allows no longer leap
constexpr double kOrigin_m = 0.05;
constexpr double kOrigin_rad = 3 * kDegree;

bool is_at_origin(const Pose2& T) {
  return T.position().norm() < kOrigin_m && std::abs(wrap_angle(T.theta)) < kOrigin_rad;
}

}  // namespace

OdometryTrail::Taken OdometryTrail::take(double stamp_s, const Pose2& T_odom_vehicle) {
  if (samples_.empty()) {
    T_trail_odom_ = T_odom_vehicle.inverse();
    keep(stamp_s, T_odom_vehicle);
    return Taken::kMotion;
  }
  const double gap_s = stamp_s - newest_s();
  if (gap_s <= 0) return Taken::kOutOfOrder;
  const double moved_m = (T_odom_vehicle.position() - T_odom_newest_.position()).norm();
  const bool is_leap = moved_m > leap_m_ + kFaster * speed_max_mps_ * std::min(gap_s, kGapMax_s);
  if (is_leap) T_trail_odom_ = samples_.back().T_odom_vehicle * T_odom_vehicle.inverse();
  keep(stamp_s, T_odom_vehicle);
  if (!is_leap) return Taken::kMotion;
  return is_at_origin(T_odom_vehicle) ? Taken::kRestart : Taken::kLeap;
}

void OdometryTrail::keep(double stamp_s, const Pose2& T_odom_vehicle) {
  if (samples_.size() == kSamplesMax) samples_.erase(samples_.begin(), samples_.begin() + kSamplesMax / 2);
  samples_.push_back({stamp_s, T_trail_odom_ * T_odom_vehicle});
  T_odom_newest_ = T_odom_vehicle;
}

Pose2 OdometryTrail::at(double stamp_s) const {
  return OdometryTrack(samples_).at(stamp_s, samples_.size());
}

}  // namespace aisle
