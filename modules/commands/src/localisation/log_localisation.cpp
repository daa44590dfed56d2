#include "localisation/log_localisation.hpp"

#include "aisle/core/process_usage.hpp"
#include "aisle/learning/walls/motion_noise.hpp"

namespace aisle {
namespace {

UncertainPose2 with_noise(const Pose2& counted) {
  return {counted, MotionNoise{}.covariance(counted)};
}

}  // namespace

LogLocalisation::LogLocalisation(const SettledLog& log, Localiser& localiser)
    : log_(log),
      localiser_(localiser),
      odometry_(log.log.odometry),
      delay_s_(log.known.odometry_delay_s.value_or(log.known.guessed_delay_s)) {}

Pose2 LogLocalisation::odometry_at(double time_s, std::size_t known) const {
  return odometry_.at(time_s - delay_s_, known);
}

/// The scanner's motion during a scan whose beams were measured one after the other.
Pose2 LogLocalisation::swept_by(const LaserScan& scan) const {
  const double half_s =
      scan.beams ? 0.5 * scan.beams->period_s * static_cast<double>(scan.ranges_m.size()) : 0;
  if (half_s == 0) return {};
  const Pose2& T_vehicle_laser = log_.log.lasers[scan.laser].T_vehicle_laser;
  return between(odometry_at(scan.time_s - half_s, scan.odometry_known) * T_vehicle_laser,
                 odometry_at(scan.time_s + half_s, scan.odometry_known) * T_vehicle_laser);
}

/// The vehicle's motion since the previous scan, by the wheels and by the first scanner's scans.
UncertainPose2 LogLocalisation::motion_to(std::size_t index) {
  const LaserScan& scan = log_.log.scans[index];
  Pose2 counted;
  if (index > 0)
    counted = between(odometry_at(log_.log.scans[index - 1].time_s, scan.odometry_known),
                      odometry_at(scan.time_s, scan.odometry_known));
  const Pose2& T_vehicle_laser = log_.log.laser().T_vehicle_laser;
  const Pose2 counted_laser = T_vehicle_laser.inverse() * counted * T_vehicle_laser;
  counted_since_ = counted_since_ * counted_laser;
  if (scan.laser != 0) return with_noise(counted);
  UncertainPose2 moved = scans_.step(points_, scan.time_s, with_noise(counted_since_)).T_last_now;
  moved.mean = counted_laser * between(counted_since_, moved.mean);
  counted_since_ = {};
  return UncertainPose2{T_vehicle_laser} * moved * UncertainPose2{T_vehicle_laser.inverse()};
}

void LogLocalisation::take(std::size_t index, LogPoses& poses) {
  const LaserScan& scan = log_.log.scans[index];
  const LaserScanner laser = log_.log.laser_of(scan);
  points_of(laser, scan.ranges_m, points_, swept_by(scan));
  const UncertainPose2 T_last_now = motion_to(index);
  path_m_ += T_last_now.mean.position().norm();
  for (Vec2& point : points_) point = laser.T_vehicle_laser * point;
  const bool was_found = localiser_.is_found();
  const double start_s = process_cpu_s();
  localiser_.take_scan({points_, laser.T_vehicle_laser.position(), scan.time_s}, T_last_now);
  const double spent_s = process_cpu_s() - start_s;
  if (was_found) {
    poses.cycle_s.push_back(spent_s);
  } else {
    poses.search_s = std::max(poses.search_s, spent_s);
  }
  poses.path_m.push_back(path_m_);
  poses.T_map_vehicle.emplace_back();
  if (was_found && !localiser_.is_found()) poses.found.back().ended_lost = true;
  if (!localiser_.is_found()) return;
  poses.T_map_vehicle.back() = localiser_.T_map_vehicle().mean;
  if (!was_found) poses.found.push_back({.first = index});
  FoundSpan& span = poses.found.back();
  span.last = index;
  span.path_m = path_m_ - poses.path_m[span.first];
}

LogPoses LogLocalisation::run(Progress& progress) {
  LogPoses poses;
  const std::size_t scans = log_.log.scans.size();
  for (std::size_t scan = 0; scan < scans; ++scan) {
    take(scan, poses);
    progress.report("localising", scan + 1, scans);
  }
  return poses;
}

}  // namespace aisle
