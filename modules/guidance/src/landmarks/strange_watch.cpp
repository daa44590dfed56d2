#include "aisle/guidance/landmarks/strange_watch.hpp"

#include <algorithm>

namespace aisle {

void StrangeWatch::start() {
  is_strange_ = false;
  way_m_ = 0;
}

void StrangeWatch::look(std::span<const LandmarkSighting> picture, bool fits, const Pose2& T_map_believed,
                        double way_m) {
  const auto could_be_known = [&](const LandmarkSighting& seen) {
    return taught_.shows(T_map_believed * seen.p_vehicle);
  };
  is_strange_ = !fits && std::count_if(picture.begin(), picture.end(), could_be_known) >= sightings_min_;
  if (fits) way_m_ /= 2;
  if (is_strange_) way_m_ += way_m;
}

}  // namespace aisle
