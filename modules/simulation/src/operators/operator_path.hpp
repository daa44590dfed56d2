#pragma once

#include <array>
#include <vector>

#include "aisle/simulation/obstacles.hpp"
#include "aisle/simulation/world.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// What a person sees as enough room for the vehicle.
Footprint with_room_to_clearance(Footprint footprint, double clearance_m);

/// How wide a person turns: somewhat wider than the vehicle can.
double turning_radius_m(const VehicleDescription& vehicle);

/// Makes the points of a route the path of a vehicle that a person drives.
class OperatorPath {
 public:
  OperatorPath(const World& world, const VehicleDescription& vehicle);

  /// A front-steered vehicle's corners are rounded as it drives them: on arcs that are wider than its
  /// narrowest, as far as the straight segments beside them allow. Where its outer front corner would come
  /// too near to a wall it turns in somewhat earlier, and comes back to the route behind the corner.
  /// @param points  two or more, each other than the one before
  std::vector<Vec2> drivable(const std::vector<Vec2>& points, bool in_reverse);

 private:
  bool is_free(const std::vector<Pose2>& path, bool in_reverse, Obstacles& obstacles) const;
  std::vector<Pose2> round(const Vec2& before, const Vec2& corner, const Vec2& after, bool in_reverse);

  VehicleDescription vehicle_;
  std::array<Obstacles, 3> obstacles_;  ///< for the vehicle with much room around it, and with less
};

}  // namespace aisle
