#include "logs/carmen_range.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

#include "aisle/core/median.hpp"

namespace aisle {

namespace {

struct ReadingExtremes {
  float largest_m = 0;    ///< of the finite readings
  std::size_t count = 0;  ///< of readings that are the largest
  std::size_t readings = 0;
};

ReadingExtremes largest_readings(const std::vector<LaserScan>& scans) {
  ReadingExtremes extremes;
  for (const LaserScan& scan : scans) {
    extremes.readings += scan.ranges_m.size();
    for (const float range_m : scan.ranges_m) {
      if (std::isinf(range_m)) continue;
      if (range_m > extremes.largest_m) {
        extremes.largest_m = range_m;
        extremes.count = 0;
      }
      extremes.count += range_m == extremes.largest_m;
    }
  }
  return extremes;
}

}  // namespace

double find_range_max_m(const std::vector<LaserScan>& scans, double announced_m) {
  if (announced_m > 0) return kUsableShareOfMaximum * announced_m;
  const ReadingExtremes extremes = largest_readings(scans);
  const bool marks_nothing_seen = extremes.count >= 3 && extremes.count * 10000 >= extremes.readings;
  return marks_nothing_seen ? kUsableShareOfMaximum * extremes.largest_m
                            : extremes.largest_m / kUsableShareOfMaximum;
}

double believable_maximum_m(const std::vector<LaserScan>& scans, double announced_m) {
  constexpr std::size_t kMarksMin = 20;
  const ReadingExtremes extremes = largest_readings(scans);
  if (extremes.largest_m >= kUsableShareOfMaximum * announced_m) return announced_m;
  std::size_t near_largest = 0;
  for (const LaserScan& scan : scans) {
    for (const float range_m : scan.ranges_m) {
      near_largest += range_m < extremes.largest_m && range_m >= kUsableShareOfMaximum * extremes.largest_m;
    }
  }
  const bool is_frequent = extremes.count >= kMarksMin && extremes.count * 1000 >= extremes.readings;
  const bool is_mark = is_frequent && extremes.count > 3 * near_largest;
  return is_mark ? extremes.largest_m : announced_m;
}

double median_reading_m(const LaserLog& log) {
  const std::size_t stride = 1 + log.scans.size() / 500;
  std::vector<float> seen_m;
  for (std::size_t i = 0; i < log.scans.size(); i += stride) {
    for (const float range_m : log.scans[i].ranges_m) {
      const bool is_mark = range_m >= log.laser().range_max_m && range_m < 2 * log.laser().range_max_m;
      if (range_m > 0 && !is_mark) seen_m.push_back(range_m);
    }
  }
  if (seen_m.empty()) return 0;
  return median(std::move(seen_m));
}

}  // namespace aisle
