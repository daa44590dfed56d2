#pragma once

#include <vector>

#include "aisle/geometry/pose2.hpp"
#include "aisle/vision/route_view.hpp"

namespace aisle {

/// Where the route was seen to end, kept while it is near: a camera that looks ahead sees nothing of what is
/// beside the vehicle and just before it.
class EdgeMemory {
 public:
  /// @param reach_m  farther points are forgotten
  explicit EdgeMemory(double reach_m) : reach_m_(reach_m) {}

  /// Takes in what a picture shows: edges come, and those where there is route now go.
  void take(const RouteView& view, const RouteSight& sight, const Pose2& T_odom_vehicle);
  /// Forgets what lies in a rectangle: known not to stand there.
  void clear(const Pose2& T_odom_middle, const Vec2& size);

  std::vector<Vec2> around(const Pose2& T_odom_vehicle) const;

 private:
  double reach_m_;
  std::vector<Vec2> p_odom_;
};

}  // namespace aisle
