#pragma once
/// A taught path in a simulated world: how its map lies there.

#include "aisle/core/result.hpp"
#include "aisle/maps/route.hpp"
#include "landmarks/landmark_evaluation.hpp"
#include "simulation_setting.hpp"

namespace aisle {

/// Places of a route in the world: as learning left it beside the building, else the route begins at the
/// world's start.
class RouteInWorld {
 public:
  static Result<RouteInWorld> read(const std::filesystem::path& building, const Route& route,
                                   const SimulationSetting& setting);
  RouteInWorld(MapTruth truth, Route route);

  Pose2 at(double along_m) const;
  Pose2 end() const { return at(route_.path.length_m()); }
  /// About where on the route a place of the world is.
  double along_m(const Pose2& T_world_vehicle) const;

 private:
  MapTruth truth_;
  Route route_;
};

}  // namespace aisle
