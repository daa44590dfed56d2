#include "logs/scan_beams.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <vector>

#include "logs/occurrences.hpp"

namespace aisle {
namespace {

constexpr double kSameAngle_rad = 1e-4;

bool are_alike(const ScanBeams& a, const ScanBeams& b) {
  return std::abs(a.first_angle_rad - b.first_angle_rad) <= kSameAngle_rad &&
         std::abs(a.angle_step_rad - b.angle_step_rad) <= kSameAngle_rad && a.period_s == b.period_s;
}

/// The first scan of the most frequent number of readings and directions; none if the laser took no scan.
const LaserScan* usual_scan(const LaserLog& log, std::size_t laser) {
  using Key = std::tuple<std::size_t, long, long>;
  std::map<Key, std::pair<std::size_t, const LaserScan*>> kinds;  // count and first scan of each
  for (const LaserScan& scan : log.scans) {
    if (scan.laser != laser) continue;
    const ScanBeams beams = scan.beams.value_or(ScanBeams{});
    auto& kind = kinds[{scan.ranges_m.size(), std::lround(beams.first_angle_rad / kSameAngle_rad),
                        std::lround(beams.angle_step_rad / kSameAngle_rad)}];
    if (kind.first++ == 0) kind.second = &scan;
  }
  const LaserScan* usual = nullptr;
  std::size_t most = 0;
  for (const auto& [key, kind] : kinds) {
    // Of equally frequent ones, the one that came first.
    if (kind.first < most || (kind.first == most && kind.second > usual)) continue;
    most = kind.first;
    usual = kind.second;
  }
  return usual;
}

}  // namespace

std::size_t usual_reading_count(const LaserLog& log, std::size_t laser) {
  const LaserScan* usual = usual_scan(log, laser);
  return usual ? usual->ranges_m.size() : 0;
}

void settle_beams(LaserLog& log, const std::string& name, Problems& warnings) {
  Occurrences others;
  std::size_t other_count = 0, usual_count = 0;
  for (std::size_t laser = 0; laser < log.lasers.size(); ++laser) {
    const LaserScan* usual = usual_scan(log, laser);
    if (!usual || !usual->beams) continue;
    const ScanBeams beams = *usual->beams;
    const std::size_t count = usual->ranges_m.size();
    log.lasers[laser].first_angle_rad = beams.first_angle_rad;
    log.lasers[laser].angle_step_rad = beams.angle_step_rad;
    for (LaserScan& scan : log.scans) {
      if (scan.laser != laser) continue;
      const bool is_alike = are_alike(*scan.beams, beams);
      if (!is_alike || scan.ranges_m.size() != count) {
        if (others.count == 0) {
          other_count = scan.ranges_m.size();
          usual_count = count;
        }
        others.add(scan.line);
      }
      if (is_alike && scan.ranges_m.size() == count && beams.period_s == 0) scan.beams.reset();
    }
  }
  if (others.count == 0) return;
  warnings.push_back(
      {{name, others.first_line},
       other_count == usual_count
           ? fmt::format("{} scans have other beam angles than most, first here; each is taken by its own",
                         others.count)
           : fmt::format("{} scans have other numbers of readings than most (here {}, most have {}), first "
                         "here; each is taken by its own",
                         others.count, other_count, usual_count)});
}

}  // namespace aisle
