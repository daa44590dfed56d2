#include "aisle/guidance/obstacles/obstacle_memory.hpp"

#include <algorithm>

namespace aisle {
namespace {

constexpr std::size_t kPlacesMax = 256;

}  // namespace

void ObstacleMemoryParams::describe(FieldList& fields) {
  fields.count("sightings_min", sightings_min, {1, 10}, "images that must show an obstacle before it counts");
  fields.count("free_sightings", free_sightings, {1, 20}, "images of free floor after which it is forgotten");
  fields.real("join_m", join_m, {0.02, 1}, "sightings closer together than this are of one obstacle");
  fields.real("kept_s", kept_s, {1, 600}, "time after which an obstacle that is not seen is forgotten");
}

ObstacleMemory::ObstacleMemory(const ObstacleMemoryParams& params) : params_(params) {
  places_.reserve(kPlacesMax);
  p_vehicle_.reserve(kPlacesMax);
}

void ObstacleMemory::see(const std::vector<Vec2>& p_vehicle_returns, const StripeScan& stripe,
                         const Pose2& T_odom_vehicle, double stamp_s) {
  const Pose2 T_vehicle_odom = T_odom_vehicle.inverse();
  for (Place& place : places_) {
    place.free_sightings = stripe.is_free(T_vehicle_odom * place.p_odom) ? place.free_sightings + 1 : 0;
  }
  for (const Vec2& p_vehicle : p_vehicle_returns) remember(T_odom_vehicle * p_vehicle, stamp_s);
  std::erase_if(places_, [&](const Place& place) {
    const bool is_unsure = place.sightings < params_.sightings_min && place.seen_s < stamp_s;
    return is_unsure || place.free_sightings >= params_.free_sightings ||
           stamp_s - place.seen_s > params_.kept_s;
  });
}

void ObstacleMemory::remember(const Vec2& p_odom, double stamp_s) {
  const auto known = std::find_if(places_.begin(), places_.end(), [&](const Place& place) {
    return (place.p_odom - p_odom).norm() < params_.join_m;
  });
  if (known == places_.end()) {
    if (places_.size() == kPlacesMax) places_.erase(places_.begin());
    places_.push_back({.p_odom = p_odom, .seen_s = stamp_s, .sightings = 1});
    return;
  }
  if (known->seen_s < stamp_s) ++known->sightings;
  known->seen_s = stamp_s;
  known->free_sightings = 0;
}

const std::vector<Vec2>& ObstacleMemory::places(const Pose2& T_odom_vehicle) {
  const Pose2 T_vehicle_odom = T_odom_vehicle.inverse();
  p_vehicle_.clear();
  for (const Place& place : places_) {
    if (place.sightings >= params_.sightings_min) p_vehicle_.push_back(T_vehicle_odom * place.p_odom);
  }
  return p_vehicle_;
}

}  // namespace aisle
