#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <stdexcept>

#include "aisle/core/angle.hpp"
#include "aisle/formats/logs/carmen_log.hpp"
#include "logs/carmen_beam_angles.hpp"
#include "logs/carmen_range.hpp"

namespace aisle {
namespace {

void check_expressible(const LaserLog& log) {
  if (log.scans.size() != log.odometry.size()) {
    throw std::invalid_argument(
        fmt::format("carmen_text: {} scans but {} odometry samples", log.scans.size(), log.odometry.size()));
  }
  if (log.scans.empty()) return;
  const std::size_t beams = log.scans.front().ranges_m.size();
  if (beams < 2) throw std::invalid_argument(fmt::format("carmen_text: scans of {} beams", beams));
  const ScanBeams angles = flaser_beams(beams, std::nullopt);
  if (std::abs(angles.first_angle_rad - log.laser().first_angle_rad) > 1e-9 ||
      std::abs(angles.angle_step_rad - log.laser().angle_step_rad) > 1e-9) {
    throw std::invalid_argument(fmt::format("carmen_text: {} beams from {} rad by {} rad are not FLASER's",
                                            beams, log.laser().first_angle_rad, log.laser().angle_step_rad));
  }
  for (const LaserScan& scan : log.scans) {
    if (scan.ranges_m.size() != beams) {
      throw std::invalid_argument(
          fmt::format("carmen_text: scans of {} and {} beams", beams, scan.ranges_m.size()));
    }
  }
}

}  // namespace

std::string carmen_text(const LaserLog& log) {
  check_expressible(log);
  const Pose2& T_vehicle_laser = log.laser().T_vehicle_laser;
  std::string text = fmt::format(
      "# FLASER num_readings [ranges] x y theta odom_x odom_y odom_theta ipc_timestamp host "
      "logger_timestamp\n"
      "PARAM robot_frontlaser_offset {}\n"
      "PARAM robot_frontlaser_side_offset {}\n"
      "PARAM robot_frontlaser_angular_offset {}\n"
      "PARAM robot_front_laser_max {}\n",
      T_vehicle_laser.x, T_vehicle_laser.y, T_vehicle_laser.theta,
      log.laser().range_max_m / kUsableShareOfMaximum);
  const auto out = std::back_inserter(text);
  for (std::size_t i = 0; i < log.scans.size(); ++i) {
    const LaserScan& scan = log.scans[i];
    const Pose2& T_odom_vehicle = log.odometry[i].T_odom_vehicle;
    const Pose2 T_odom_laser = T_odom_vehicle * T_vehicle_laser;
    fmt::format_to(out, "FLASER {}", scan.ranges_m.size());
    for (const float range_m : scan.ranges_m) fmt::format_to(out, " {}", range_m);
    fmt::format_to(out, " {} {} {} {} {} {} {} aisle {}\n", T_odom_laser.x, T_odom_laser.y,
                   T_odom_laser.theta, T_odom_vehicle.x, T_odom_vehicle.y, T_odom_vehicle.theta, scan.stamp_s,
                   scan.stamp_s);
  }
  return text;
}

}  // namespace aisle
