#pragma once

#include <vector>

#include "aisle/geometry/pose2.hpp"
#include "aisle/vision/route/route_view.hpp"

namespace aisle {

/// A point where the route was seen to end.
struct SeenEdge {
  Vec2 p_vehicle = Vec2::Zero();
  double seen_from_m = 0;  ///< from base_link; what was seen from far may be elsewhere
};

/// Where the route was seen to end, kept while it is near: a camera that looks ahead sees nothing of what is
/// beside the vehicle and just before it. Who came where the route was free, went on and left the view is
/// forgotten after some seconds; what was never seen to move stays.
class EdgeMemory {
 public:
  /// @param reach_m  farther points are forgotten
  explicit EdgeMemory(double reach_m) : reach_m_(reach_m) {}

  /// Takes in what an image shows: edges come, and those where there is route now go.
  void take(const RouteView& view, const RouteSight& sight, const Pose2& T_odom_vehicle, double stamp_s);
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
    bool is_floor_edge = true;
    double first_s = 0, last_s = 0;  ///< when it was seen
    bool has_come = false;           ///< where the route was seen to be free
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
  std::vector<Edge> gone_;         ///< had come, and the route was seen there again
  std::vector<Edge> seen_, come_;  ///< by the latest image; kept for their memory
};

}  // namespace aisle
