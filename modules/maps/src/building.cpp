#include "aisle/maps/building.hpp"

#include <algorithm>

namespace aisle {

Pose2 home_of(const Building& building) {
  const auto home = std::find_if(building.places.begin(), building.places.end(),
                                 [](const MapPlace& place) { return place.name == kHomePlace; });
  return home == building.places.end() ? Pose2{} : home->T_map_place;
}

std::vector<Barrier> lines_not_crossed(const Building& building) {
  std::vector<Barrier> lines = outlines(building.zones);
  lines.insert(lines.end(), building.barriers.begin(), building.barriers.end());
  return lines;
}

}  // namespace aisle
