#include "landmarks/landmark_view.hpp"

#include <algorithm>
#include <cmath>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

constexpr double kSameSide_rad = 50 * kDegree;

double bearing(const Vec2& p_vehicle) {
  return std::atan2(p_vehicle.y(), p_vehicle.x());
}

}  // namespace

bool is_known_from_behind(const Landmark& landmark, const Vec2& p_map_vehicle) {
  return (p_map_vehicle - landmark.p_map).dot(landmark.seen_from) < 0;
}

bool was_seen_from_about(const Landmark& landmark, const Vec2& p_map_vehicle) {
  const Vec2 from = p_map_vehicle - landmark.p_map;
  const double distance_m = from.norm();
  return distance_m >= landmark.seen_near_m && distance_m <= landmark.seen_far_m &&
         from.dot(landmark.seen_from) > std::cos(kSameSide_rad) * distance_m;
}

LandmarkView::LandmarkView(std::span<const LandmarkSighting> sightings) : left_rad_(-kPi), right_rad_(kPi) {
  for (const LandmarkSighting& sighting : sightings) {
    far_m_ = std::max(far_m_, sighting.p_vehicle.norm());
    left_rad_ = std::max(left_rad_, bearing(sighting.p_vehicle));
    right_rad_ = std::min(right_rad_, bearing(sighting.p_vehicle));
  }
}

bool LandmarkView::expects(const Landmark& landmark, const Pose2& T_map_vehicle) const {
  const Vec2 p_vehicle = T_map_vehicle.inverse() * landmark.p_map;
  return p_vehicle.norm() <= far_m_ && bearing(p_vehicle) <= left_rad_ && bearing(p_vehicle) >= right_rad_ &&
         was_seen_from_about(landmark, T_map_vehicle.position());
}

}  // namespace aisle
