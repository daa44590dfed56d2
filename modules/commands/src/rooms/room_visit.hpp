#pragma once
/// A taught route in a simulated world.

#include "aisle/core/result.hpp"
#include "aisle/maps/route.hpp"
#include "landmarks/landmark_evaluation.hpp"
#include "simulation_setting.hpp"

namespace aisle {

/// How a route lies in the world: by the truth that learning wrote beside the building, else the route begins
/// at the world's start.
class RouteInWorld {
 public:
  static Result<RouteInWorld> read(const std::filesystem::path& building, const Route& route,
                                   const SimulationSetting& setting);
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
