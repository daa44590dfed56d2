#include "aisle/learning/landmarks/landmark_patterns.hpp"

#include <algorithm>

#include "landmarks/landmark_view.hpp"

namespace aisle {
namespace {

constexpr double kFromBehind = 0.3;  // share of a landmark's weight if it was only seen from the other side

}  // namespace

double confidence_weight(const Vec2& p_vehicle, double confidence_m2) {
  return 1 / (1 + p_vehicle.squaredNorm() / confidence_m2);
}

void LandmarkPatterns::gather(const LandmarkMap& map, std::span<const LandmarkSighting> sightings,
                              const Pose2& T_map_vehicle, double confidence_m2, const MwghtWindow& window,
                              double reach_m) {
  near.clear();
  learned.clear();
  seen.clear();
  if (sightings.empty()) return;
  Vec2 low = sightings.front().p_vehicle, high = low;
  for (const LandmarkSighting& sighting : sightings) {
    low = low.cwiseMin(sighting.p_vehicle);
    high = high.cwiseMax(sighting.p_vehicle);
    seen.push_back({sighting.p_vehicle, confidence_weight(sighting.p_vehicle, confidence_m2)});
  }
  const double moved_m =
      std::max(window.x_half_m, window.y_half_m) + high.norm() * window.turn_half_rad + reach_m;
  map.within(T_map_vehicle * Vec2((low + high) / 2), (high - low).norm() / 2 + moved_m, near);
  const Pose2 T_vehicle_map = T_map_vehicle.inverse();
  for (const int i : near) {
    const Landmark& landmark = map[static_cast<std::size_t>(i)];
    const double side = is_known_from_behind(landmark, T_map_vehicle.position()) ? kFromBehind : 1;
    learned.push_back({T_vehicle_map * landmark.p_map, side * landmark.weight});
  }
}

}  // namespace aisle
