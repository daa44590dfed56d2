#pragma once

#include <span>
#include <vector>

#include "aisle/core/parameters.hpp"
#include "aisle/geometry/pose2.hpp"
#include "aisle/guidance/rooms/edge_memory.hpp"
#include "aisle/guidance/rooms/taught_edges.hpp"

namespace aisle {

struct EdgePlaceParams {
  double window_m = 4;
  double reach_m = 0.3;
  double deviation_m = 0.05;
  double far_m = 2.5;
  double moved_m = 0.1;
  double set_down_m = 0.35;
  double set_down_rad = 12 * kDegree;
  double drift_m = 0.03;
  double drift_rad = 1 * kDegree;
  int points_min = 20;
  double fitting_min = 0.5;
  double gain = 0.3;

  void describe(FieldList& fields);
};

/// Tells by the edges of the route, as far as they are where they were taught, where the vehicle is: what was
/// seen of them on the last metres is laid onto them, at first from all poses about the one at which the
/// vehicle was set down, then from where the odometry expects them. One image alone may show a single line,
/// along which it could be anywhere. Things may have been moved since: each of their sides may stand off by
/// itself, at a cost that grows with its length, so that what is seen from near has no more say than what is
/// seen from far, and what stands otherwise than the rest counts little. The expected pose is trusted the
/// more, the more images it rests on: what the first ones showed wrongly is soon made up for.
class EdgePlace {
 public:
  /// @param taught  may be empty: then `map` stays `odom`
  EdgePlace(const EdgePlaceParams& params, const std::vector<RouteEdge>& taught);

  /// Looks up the edges of the path about there, for `taught` and `take`.
  void come_to(const Pose2& T_odom_vehicle, double along_m);
  /// Takes in the edges that have been seen around the vehicle.
  /// @param along_m  about where on the route the vehicle is
  void take(std::span<const SeenEdge> seen, const Pose2& T_odom_vehicle, double along_m);

  const Pose2& T_map_odom() const { return T_map_odom_; }
  /// The edges have been found to fit.
  bool is_sure() const { return fits_ > 0; }
  const TaughtEdges& taught() const { return taught_; }

 private:
  struct Fit {
    Pose2 T_map_vehicle;
    double fitting_share = 0;  ///< of the points that lie on edges
  };

  /// One image row is the more floor, the farther away it is.
  double variance_m2(const SeenEdge& seen) const;
  Pose2 most_alike(std::span<const SeenEdge> seen, const Pose2& T_map_expected) const;
  Fit refined(std::span<const SeenEdge> seen, const Pose2& T_map_begin, const Pose2& T_map_expected,
              double sigma_m, double sigma_rad) const;

  EdgePlaceParams params_;
  TaughtEdges taught_;
  Pose2 T_map_odom_;
  int fits_ = 0;  ///< images that its pose rests on
};

}  // namespace aisle
