#include "aisle/guidance/landmarks/unmatched_monitor.hpp"

#include <algorithm>

namespace aisle {

void UnmatchedMonitor::start() {
  is_unmatched_ = false;
  travelled_m_ = 0;
}

void UnmatchedMonitor::look(std::span<const LandmarkSighting> image, bool fits, const Pose2& T_map_believed,
                            double path_m) {
  const auto could_be_known = [&](const LandmarkSighting& seen) {
    return taught_.shows(T_map_believed * seen.p_vehicle);
  };
  is_unmatched_ = !fits && std::count_if(image.begin(), image.end(), could_be_known) >= sightings_min_;
  if (fits) travelled_m_ /= 2;
  if (is_unmatched_) travelled_m_ += path_m;
}

}  // namespace aisle
