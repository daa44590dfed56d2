#pragma once
/// The log of a known drive, with any of the faults that logs have.

#include <functional>
#include <utility>
#include <vector>

#include "aisle/core/random.hpp"
#include "aisle/vehicle/laser_log.hpp"
#include "cast_scans.hpp"

namespace aisle {

/// Where a vehicle is that drives figures of eight through `uneven_room`, one in 25 s.
inline Pose2 on_figure_of_eight(double time_s) {
  constexpr double kRound_radps = 2 * kPi / 25;
  const double phase_rad = kRound_radps * time_s;
  const Vec2 velocity(2.4 * std::cos(phase_rad), 2 * 1.5 * std::cos(2 * phase_rad));
  return {4 + 2.4 * std::sin(phase_rad), 2.4 + 1.5 * std::sin(2 * phase_rad), heading_of(velocity)};
}

/// A drive and how it was recorded: odometry 20 times a second, from a frame that begins with the drive, and
/// every other time a scan. The lines of the recording are 1, 2, 3 ...
struct RecordedDrive {
  double duration_s = 40;
  std::vector<Segment2> walls = uneven_room();
  std::function<Pose2(double)> T_map_vehicle = on_figure_of_eight;
  LaserScanner laser = kThreeQuarters;  ///< as it is; the log says the same
  double range_sigma_m = 0;
  double odometry_scale = 1;      ///< distance counted per distance driven
  double odometry_sigma_rad = 0;  ///< of each step
  double odometry_late_s = 0;     ///< its stamps are so much later than the scans'
  std::size_t beams = kThreeQuartersBeams;

  LaserLog log() const {
    constexpr double kStep_s = 0.05;
    Random random(1);
    LaserLog log;
    log.laser() = laser;
    Pose2 T_odom_vehicle;
    long line = 0;
    for (int i = 0; i * kStep_s <= duration_s; ++i) {
      const double time_s = i * kStep_s;
      if (i > 0) {
        const Pose2 step = between(T_map_vehicle(time_s - kStep_s), T_map_vehicle(time_s));
        T_odom_vehicle = T_odom_vehicle * Pose2{odometry_scale * step.x, odometry_scale * step.y,
                                                step.theta + random.normal(odometry_sigma_rad)};
      }
      log.odometry.push_back({time_s + odometry_late_s, T_odom_vehicle, ++line});
      if (i % 2 != 0) continue;
      LaserScan scan{
          .stamp_s = time_s, .time_s = time_s, .odometry_known = log.odometry.size(), .line = ++line};
      scan.ranges_m = cast_scan(walls, T_map_vehicle(time_s) * laser.T_vehicle_laser, laser, beams);
      for (float& range_m : scan.ranges_m) {
        if (range_m < laser.range_max_m) range_m += static_cast<float>(random.normal(range_sigma_m));
      }
      log.scans.push_back(std::move(scan));
    }
    return log;
  }
};

}  // namespace aisle
