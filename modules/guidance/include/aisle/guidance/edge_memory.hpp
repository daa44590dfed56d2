#pragma once

#include <vector>

#include "aisle/geometry/pose2.hpp"
#include "aisle/vision/route_view.hpp"

namespace aisle {

/// A point where the route was seen to end.
struct SeenEdge {
  Vec2 p_vehicle = Vec2::Zero();
  double seen_from_m = 0;  ///< from base_link; what was seen from far may be elsewhere
};

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

  /// What stands there, also where its foot was not in view.
  std::vector<Vec2> around(const Pose2& T_odom_vehicle) const;
  /// The feet of what stands there.
  std::vector<SeenEdge> seen_around(const Pose2& T_odom_vehicle) const;

 private:
  struct Edge {
    Vec2 p_odom = Vec2::Zero();
    double seen_from_m = 0;
    bool is_foot = true;
  };

  void take(const Edge& seen);

  double reach_m_;
  std::vector<Edge> edges_;
};

}  // namespace aisle
