#pragma once

#include "aisle/evaluation/map_truth.hpp"
#include "aisle/maps/route.hpp"

namespace aisle {

/// How a taught route lies in the world.
class RouteInWorld {
 public:
  RouteInWorld(MapTruth truth, Route route);

  Pose2 at(double along_m) const;
  Pose2 end() const { return at(route_.path.length_m()); }
  /// Approximate position along the route of a pose in the world [m].
  double along_m(const Pose2& T_world_vehicle) const;

 private:
  MapTruth truth_;
  Route route_;
};

}  // namespace aisle
