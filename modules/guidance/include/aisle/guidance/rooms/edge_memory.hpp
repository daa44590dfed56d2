#pragma once

#include <vector>

#include "aisle/geometry/pose2.hpp"
#include "aisle/guidance/odometry_history.hpp"
#include "aisle/vision/route/route_view.hpp"

namespace aisle {

/// A point on an edge of the route, as it was seen.
struct SeenEdge {
  Vec2 p_vehicle = Vec2::Zero();
  double seen_from_m = 0;  ///< distance from base_link when seen; far points are inaccurate
};

/// Remembers the route's edges near the vehicle: a camera that looks ahead sees neither what is beside the
/// vehicle nor what is right before it. A person who walked onto the route, moved on and left the view is
/// forgotten after some seconds; what was never seen to move stays.
class EdgeMemory {
 public:
  /// @param reach_m  points farther from base_link are forgotten
  explicit EdgeMemory(double reach_m) : reach_m_(reach_m) {}

  /// Takes in an image: adds its edges, and removes those where it shows free route.
  void take(const RouteView& view, const RouteSight& sight, const Pose2& T_odom_vehicle, double stamp_s);
  /// The odometry of the last cycles has been corrected: what was seen in them was elsewhere.
  void correct(const OdometryHistory& before, const OdometryHistory& now);
  /// Forgets all edges in a rectangle, where they are known to be no obstacles.
  /// @param size  along x and y [m]
  void clear(const Pose2& T_odom_middle, const Vec2& size);

  /// All obstacles around [base_link], even if their floor points were not in view.
  std::vector<Vec2> around(const Pose2& T_odom_vehicle) const;
  /// The floor points among them.
  std::vector<SeenEdge> seen_around(const Pose2& T_odom_vehicle) const;

 private:
  struct Edge {
    Vec2 p_odom = Vec2::Zero();
    double seen_from_m = 0;
    bool is_floor_edge = true;
    double first_s = 0, last_s = 0;  ///< when it was first and last seen
    bool has_come = false;           ///< it appeared where the route had been free
  };
  /// An image of some seconds ago.
  struct Look {
    double stamp_s = 0;
    Pose2 T_odom_vehicle;
    RouteSight sight;
  };

  void forget_gone(const RouteView& view, const RouteSight& sight, const Pose2& T_odom_vehicle);
  void forget_moved_on(double stamp_s);
  bool was_free(const RouteView& view, const Vec2& p_odom, double stamp_s) const;
  bool has_stood_at(const Vec2& p_odom, double stamp_s) const;
  static bool is_beside_any(const std::vector<Edge>& edges, const Vec2& p_odom);
  bool has_moved_on(const Edge& edge) const;
  void take(const Edge& seen);
  void keep_look(const RouteSight& sight, const Pose2& T_odom_vehicle, double stamp_s);

  double reach_m_;
  std::vector<Edge> edges_;
  std::vector<Look> looks_;
  std::vector<Edge> gone_;         ///< edges that had come, where the route was seen again
  std::vector<Edge> seen_, come_;  ///< of the last image; kept for their memory
};

}  // namespace aisle
