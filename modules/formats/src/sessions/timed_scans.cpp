#include "aisle/formats/sessions/timed_scans.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "aisle/vehicle/odometry_track.hpp"

namespace aisle {
namespace {

constexpr double kScanStampMax_s = 2147483647;
constexpr double kScanStepMin_s = 1e-6;
constexpr double kSessionRangeMin_m = 0.5, kSessionRangeMax_m = 200;  // what a vehicle file may say

LaserScanner session_scanner(const LaserLog& log) {
  const auto first =
      std::find_if(log.scans.begin(), log.scans.end(), [](const LaserScan& scan) { return scan.laser == 0; });
  LaserScanner scanner = first == log.scans.end() ? log.laser() : log.laser_of(*first);
  scanner.first_angle_rad = wrap_angle(scanner.first_angle_rad);
  scanner.range_max_m = std::clamp(scanner.range_max_m, kSessionRangeMin_m, kSessionRangeMax_m);
  return scanner;
}

bool has_beams(const LaserScanner& own, std::size_t own_beams, const LaserScanner& scanner,
               std::size_t beams) {
  return own_beams == beams && own.first_angle_rad == scanner.first_angle_rad &&
         own.angle_step_rad == scanner.angle_step_rad;
}

/// The reading of `from` next to each beam of `scanner`; 0 where there is none.
std::vector<float> readings_by(const LaserScanner& scanner, std::size_t beams, const LaserScanner& from,
                               const std::vector<float>& ranges_m) {
  std::vector<float> readings_m(beams, 0);
  for (std::size_t beam = 0; beam < beams; ++beam) {
    const double ahead_rad = wrap_angle(scanner.beam_angle(beam) - from.first_angle_rad);
    for (const double turned_rad : {ahead_rad, ahead_rad + 2 * kPi}) {
      const double index = std::round(turned_rad / from.angle_step_rad);
      if (index >= 0 && index < static_cast<double>(ranges_m.size()))
        readings_m[beam] = ranges_m[static_cast<std::size_t>(index)];
    }
  }
  return readings_m;
}

TimedScan timed_scan(LaserScan& scan, const LaserScanner& own, const LaserScanner& scanner,
                     std::size_t beams) {
  const double period_s = scan.beams ? scan.beams->period_s : 0;
  const double lead_s = std::abs(period_s) * static_cast<double>(scan.ranges_m.size() - 1) / 2;
  TimedScan timed;
  timed.stamp_s = scan.time_s;
  timed.scan.stamp_s = std::max(0.0, scan.time_s - lead_s);
  timed.scan.ranges_m = has_beams(own, scan.ranges_m.size(), scanner, beams)
                            ? std::move(scan.ranges_m)
                            : readings_by(scanner, beams, own, scan.ranges_m);
  timed.reading_period_s = period_s;
  return timed;
}

}  // namespace

TimedScans timed_scans(LaserLog log, const std::string& file, Problems& warnings) {
  TimedScans timed{.scanner = session_scanner(log), .scans = {}};
  const OdometryTrack odometry(log.odometry);
  std::size_t beams = 0, changed = 0, of_others = 0, not_later = 0;
  double before_s = -kScanStepMin_s;
  for (LaserScan& scan : log.scans) {
    const bool is_later = scan.time_s >= before_s + kScanStepMin_s && scan.time_s <= kScanStampMax_s;
    if (scan.laser != 0 || !is_later || scan.ranges_m.empty()) {
      ++(scan.laser != 0 ? of_others : not_later);
      continue;
    }
    before_s = scan.time_s;
    if (beams == 0) beams = scan.ranges_m.size();
    LaserScanner own = log.laser_of(scan);
    own.first_angle_rad = wrap_angle(own.first_angle_rad);
    if (!has_beams(own, scan.ranges_m.size(), timed.scanner, beams)) ++changed;
    timed.scans.push_back(timed_scan(scan, own, timed.scanner, beams));
    if (!log.odometry.empty()) timed.scans.back().T_odom_vehicle = odometry.at(before_s, log.odometry.size());
  }
  timed.left_out = of_others + not_later;
  const auto warn = [&](std::size_t scans, const char* what) {
    if (scans > 0) warnings.push_back({{file}, fmt::format("{} scans {}", scans, what)});
  };
  warn(of_others, "of other scanners than the first are left out: a session knows one");
  warn(not_later, "have no later stamp than the scan before, and are left out");
  warn(changed, "have other beams than the first; its beams get the readings next to them");
  return timed;
}

}  // namespace aisle
