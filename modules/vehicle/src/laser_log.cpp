#include "aisle/vehicle/laser_log.hpp"

#include <algorithm>

namespace aisle {

double LaserLog::scan_period_s() const {
  if (scans.size() < 2) return 0;
  std::vector<double> steps(scans.size() - 1);
  for (std::size_t i = 0; i < steps.size(); ++i) steps[i] = scans[i + 1].time_s - scans[i].time_s;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

}  // namespace aisle
