#include "aisle/evaluation/rooms/route_in_world.hpp"

#include <utility>

namespace aisle {

RouteInWorld::RouteInWorld(MapTruth truth, Route route)
    : truth_(std::move(truth)), route_(std::move(route)) {}

Pose2 RouteInWorld::at(double along_m) const {
  return truth_.in_world(route_.path.at(along_m).T_map_path);
}

double RouteInWorld::along_m(const Pose2& T_world_vehicle) const {
  constexpr double kStep_m = 0.05;
  const int steps = static_cast<int>(route_.path.length_m() / kStep_m);
  double best_m = 0, least_m = -1;
  for (int i = 0; i <= steps; ++i) {
    const double off_m = (at(i * kStep_m).position() - T_world_vehicle.position()).norm();
    if (least_m >= 0 && off_m > least_m) continue;
    least_m = off_m;
    best_m = i * kStep_m;
  }
  return best_m;
}

}  // namespace aisle
