#pragma once

#include <cmath>

#include "aisle/formats/logs/laser_recording.hpp"
#include "fuzz_input.hpp"

namespace aisle {

/// What every reader of recordings promises of what it gives.
inline void check_recording_promises(const LaserRecording& recording) {
  const LaserLog& log = recording.log;
  require(!log.scans.empty() && !log.lasers.empty());
  for (const LaserScanner& laser : log.lasers) require(laser.T_vehicle_laser.is_finite());
  double time_s = log.scans.front().time_s;
  for (const LaserScan& scan : log.scans) {
    require(scan.laser < log.lasers.size() && scan.ranges_m.size() >= 2);
    require(scan.odometry_known <= log.odometry.size());
    require(scan.time_s >= time_s);
    time_s = scan.time_s;
    const LaserScanner laser = log.laser_of(scan);
    require(laser.angle_step_rad > 0 && std::isfinite(laser.first_angle_rad));
    for (const float range_m : scan.ranges_m) require(range_m >= 0 && std::isfinite(range_m));
  }
  for (const OdometrySample& sample : log.odometry) require(sample.T_odom_vehicle.is_finite());
}

}  // namespace aisle
