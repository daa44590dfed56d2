#include "logs/rawlog_odometry.hpp"

namespace aisle {

void RawlogOdometry::add(const MrptOdometry& odometry, long object) {
  if (kind_ == Kind::kMovements) return;
  kind_ = Kind::kPoses;
  log_.odometry.push_back({odometry.stamp_s, odometry.T_odom_vehicle, object});
}

void RawlogOdometry::begin_collection() {
  T_odom_before_ = T_odom_vehicle_;
  has_movement_ = by_odometry_ = false;
}

void RawlogOdometry::add(const MrptMovement& movement) {
  if (kind_ == Kind::kPoses) return;
  kind_ = Kind::kMovements;
  if (has_movement_ && (by_odometry_ || !movement.by_odometry)) return;
  T_odom_vehicle_ = T_odom_before_ * movement.motion;
  has_movement_ = is_pending_ = true;
  by_odometry_ = movement.by_odometry;
}

void RawlogOdometry::reach_scan(double stamp_s, long object) {
  if (!is_pending_) return;
  log_.odometry.push_back({stamp_s, T_odom_vehicle_, object});
  is_pending_ = false;
}

void RawlogOdometry::finish() {
  if (kind_ != Kind::kMovements || log_.scans.empty() || log_.scans.front().odometry_known > 0) return;
  const LaserScan& first = log_.scans.front();
  log_.odometry.insert(log_.odometry.begin(), {first.stamp_s, Pose2{}, first.line});
  for (LaserScan& scan : log_.scans) ++scan.odometry_known;
}

}  // namespace aisle
