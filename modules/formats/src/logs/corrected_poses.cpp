#include "logs/corrected_poses.hpp"

#include <cmath>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

constexpr double kCompareEvery_m = 5;
constexpr double kLag_m = 0.5;  // the vehicle drives on between an ODOM line and the scan after it
constexpr double kLag_rad = 5 * kDegree;

}  // namespace

void CorrectedPoses::add(const Pose2& T_odom, const Pose2& T_scan, long line) {
  if (!first_) first_ = latest_ = Pair{T_odom, T_scan};
  if (between(latest_->T_odom, T_odom).position().norm() < kCompareEvery_m) return;
  latest_ = Pair{T_odom, T_scan};
  const Pose2 by_odometry = between(first_->T_odom, T_odom);
  const Pose2 difference = between(by_odometry, between(first_->T_scan, T_scan));
  const double allowed_m = kLag_m + kLag_rad * by_odometry.position().norm();
  const bool differs = difference.position().norm() > allowed_m || std::abs(difference.theta) > kLag_rad;
  if (differs && different_++ == 0) first_line_ = line;
  same_ += !differs;
}

std::optional<long> CorrectedPoses::first_line() const {
  // A slip or a jump of one of the two is not a correction.
  if (different_ < 3 || different_ * 5 < same_) return std::nullopt;
  return first_line_;
}

}  // namespace aisle
