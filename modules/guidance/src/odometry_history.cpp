#include "aisle/guidance/odometry_history.hpp"

#include <algorithm>

#include "aisle/vehicle/odometry_step.hpp"

namespace aisle {

Pose2 OdometryHistory::step(const OdometryReading& reading) const {
  const auto* motion = std::get_if<FrontSteeredMotion>(&reading);
  return odometry_step(vehicle_, motion == nullptr ? reading : error_.corrected(*motion));
}

void OdometryHistory::correct(const OdometryCorrection& error, double from_s) {
  error_ = error;
  const std::size_t known = std::min(moves_, kCycles);
  for (std::size_t later = known; later-- > 1;) {
    StampedPose& pose = poses_[(moves_ - later) % kCycles];
    if (pose.stamp_s > from_s) pose.T_odom_vehicle = ago(later).T_odom_vehicle * step(pose.reading);
  }
}

void OdometryHistory::move(const Observation& observation) {
  const Pose2 T_odom_before = T_odom_vehicle();
  poses_[moves_++ % kCycles] = {observation.stamp_s, T_odom_before * step(observation.odometry),
                                observation.odometry};
}

Pose2 OdometryHistory::T_odom_at(double stamp_s) const {
  const std::size_t known = std::min(moves_, kCycles);
  for (std::size_t cycles = 0; cycles + 1 < known; ++cycles) {
    const StampedPose &after = ago(cycles), &before = ago(cycles + 1);
    if (stamp_s >= after.stamp_s) return after.T_odom_vehicle;
    if (stamp_s > before.stamp_s)
      return interpolate(before.T_odom_vehicle, after.T_odom_vehicle,
                         (stamp_s - before.stamp_s) / (after.stamp_s - before.stamp_s));
  }
  return ago(known == 0 ? 0 : known - 1).T_odom_vehicle;
}

int OdometryHistory::cycles_since(double stamp_s) const {
  const std::size_t known = std::min(moves_, kCycles);
  std::size_t cycles = 0;
  while (cycles + 1 < known && stamp_s <= (ago(cycles).stamp_s + ago(cycles + 1).stamp_s) / 2) ++cycles;
  return static_cast<int>(cycles);
}

}  // namespace aisle
