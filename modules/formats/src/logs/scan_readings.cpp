#include "logs/scan_readings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace aisle {
namespace {

constexpr double kReadingMax_m = 1e6;

}  // namespace

float ReadingCounts::kept(double reading_m, long line) {
  if (reading_m == std::numeric_limits<double>::infinity()) {
    beyond_range.add(line);
    return std::numeric_limits<float>::infinity();
  }
  if (reading_m >= 0 && reading_m <= kReadingMax_m) return static_cast<float>(reading_m);
  void_readings.add(line);
  return 0;
}

void ReadingCounts::warn(const std::string& name, Problems& warnings) const {
  if (void_readings.count > 0) {
    warnings.push_back({{name, void_readings.first_line},
                        fmt::format("{} readings are NaN, negative or otherwise no distances, first here; "
                                    "these beams tell nothing",
                                    void_readings.count)});
  }
  if (beyond_range.count > 0) {
    warnings.push_back(
        {{name, beyond_range.first_line},
         fmt::format("{} readings are infinite, first here: nothing was in range", beyond_range.count)});
  }
}

void replace_infinite_readings(LaserLog& log) {
  for (LaserScan& scan : log.scans) {
    const auto range_max_m = static_cast<float>(log.lasers[scan.laser].range_max_m);
    // The next float above: a comparison in double precision must find it at the maximum.
    const float nothing_seen_m = std::nextafter(range_max_m, std::numeric_limits<float>::infinity());
    for (float& range_m : scan.ranges_m) {
      if (std::isinf(range_m)) range_m = range_max_m > 0 ? nothing_seen_m : 0;
    }
  }
}

void make_counter_clockwise(LaserScan& scan) {
  std::reverse(scan.ranges_m.begin(), scan.ranges_m.end());
  if (!scan.beams || scan.ranges_m.empty()) return;
  const auto steps = static_cast<double>(scan.ranges_m.size() - 1);
  scan.beams->first_angle_rad += scan.beams->angle_step_rad * steps;
  scan.beams->angle_step_rad = -scan.beams->angle_step_rad;
  scan.beams->period_s = -scan.beams->period_s;
}

}  // namespace aisle
