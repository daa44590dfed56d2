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

LandmarkView::LandmarkView(std::span<const LandmarkSighting> sightings) : left_rad_(-kPi), right_rad_(kPi) {
  for (const LandmarkSighting& sighting : sightings) {
    far_m_ = std::max(far_m_, sighting.p_vehicle.norm());
    left_rad_ = std::max(left_rad_, bearing(sighting.p_vehicle));
    right_rad_ = std::min(right_rad_, bearing(sighting.p_vehicle));
  }
}

bool LandmarkView::expects(const Landmark& landmark, const Pose2& T_map_vehicle) const {
  const Vec2 p_vehicle = T_map_vehicle.inverse() * landmark.p_map;
  const double distance_m = p_vehicle.norm();
  if (distance_m < landmark.seen_near_m || distance_m > landmark.seen_far_m) return false;
  if (distance_m > far_m_ || bearing(p_vehicle) > left_rad_ || bearing(p_vehicle) < right_rad_) return false;
  const Vec2 from = (T_map_vehicle.position() - landmark.p_map).normalized();
  return from.dot(landmark.seen_from) > std::cos(kSameSide_rad);
}

}  // namespace aisle
