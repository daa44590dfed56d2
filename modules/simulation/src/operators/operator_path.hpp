#pragma once

#include <array>
#include <vector>

#include "aisle/simulation/obstacles.hpp"
#include "aisle/simulation/world.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// The footprint with a clearance on all sides.
Footprint with_clearance(Footprint footprint, double clearance_m);

/// The radius at which a person turns: somewhat larger than the vehicle's least.
double turning_radius_m(const VehicleDescription& vehicle);

/// Turns the points of a route into a path as a person drives it.
class OperatorPath {
 public:
  OperatorPath(const World& world, const VehicleDescription& vehicle);

  /// A front-steered vehicle's corners are rounded as it drives them: on arcs wider than its
  /// narrowest, as far as the straight segments beside them allow. Where its outer front corner would come
  /// too near to a wall, it turns in somewhat earlier and returns to the route beyond the corner.
  /// @param points  two or more, each different from the previous one
  std::vector<Vec2> drivable(const std::vector<Vec2>& points, bool in_reverse);

 private:
  bool is_free(const std::vector<Pose2>& path, bool in_reverse, Obstacles& obstacles) const;
  std::vector<Pose2> round(const Vec2& before, const Vec2& corner, const Vec2& after, bool in_reverse);

  VehicleDescription vehicle_;
  std::array<Obstacles, 3> obstacles_;  ///< for the vehicle with much clearance, and with less
};

}  // namespace aisle
