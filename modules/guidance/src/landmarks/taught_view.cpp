#include "aisle/guidance/landmarks/taught_view.hpp"

#include <algorithm>
#include <cmath>

#include "aisle/learning/landmarks/landmark_expectation.hpp"

namespace aisle {
namespace {

constexpr double kTaughtPlacesApart_m = 0.25;  // between the poses along a route

}  // namespace

void TaughtView::add(const Path& route) {
  const auto steps = static_cast<int>(std::ceil(route.length_m() / kTaughtPlacesApart_m));
  for (int i = 0; i <= steps; ++i) {
    const Pose2 place = route.at(route.length_m() * i / std::max(steps, 1)).T_map_path;
    index_.add({place.position(), place.position()}, static_cast<int>(T_map_taught_.size()));
    T_map_taught_.push_back(place);
  }
}

bool TaughtView::shows(const Vec2& p_map) {
  index_.query(p_map, p_map, kFloorPointFarthest_m, near_);
  return std::any_of(near_.begin(), near_.end(), [&](int place) {
    return shows_from(T_map_taught_[static_cast<std::size_t>(place)], p_map);
  });
}

bool TaughtView::shows_from(const Pose2& T_map_vehicle, const Vec2& p_map) const {
  const Vec2 p_vehicle = T_map_vehicle.inverse() * p_map;
  return p_vehicle.norm() <= kFloorPointFarthest_m && floor_.shows(p_vehicle);
}

}  // namespace aisle
