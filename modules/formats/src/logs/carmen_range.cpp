#include "logs/carmen_range.hpp"

#include <cstddef>
#include <utility>

#include "aisle/core/median.hpp"

namespace aisle {

double find_range_max_m(const std::vector<LaserScan>& scans, double announced_m) {
  if (announced_m > 0) return kUsableShareOfMaximum * announced_m;
  float largest_m = 0;
  std::size_t largest_count = 0;
  std::size_t readings = 0;
  for (const LaserScan& scan : scans) {
    readings += scan.ranges_m.size();
    for (const float range_m : scan.ranges_m) {
      if (range_m > largest_m) {
        largest_m = range_m;
        largest_count = 0;
      }
      largest_count += range_m == largest_m;
    }
  }
  const bool marks_nothing_seen = largest_count >= 3 && largest_count * 10000 >= readings;
  return marks_nothing_seen ? kUsableShareOfMaximum * largest_m : largest_m / kUsableShareOfMaximum;
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
