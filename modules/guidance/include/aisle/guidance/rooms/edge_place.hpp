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

/// Localises by the route's edges, as far as they are where they were taught. It matches the edges seen on
/// the last metres with the taught ones, as a single image may show one line only, along which the vehicle
/// could be anywhere. The first match tries all poses around the initial pose; later ones start from the
/// odometry. Objects may have been moved since teaching: each side of an object has its own displacement, at
/// a cost that grows with its length. So near objects weigh no more than far ones, and a moved one counts
/// little. The expected pose is trusted more with every image, so that errors of the first images are soon
/// corrected.
class EdgePlace {
 public:
  /// @param taught  may be empty: then the frames `map` and `odom` stay the same
  EdgePlace(const EdgePlaceParams& params, const std::vector<RouteEdge>& taught);

  /// Selects the edges taught near this place, for `taught` and `take`.
  /// @param along_m  about where on the route the vehicle is
  void come_to(const Pose2& T_odom_vehicle, double along_m);
  /// Corrects the pose by the edges seen around the vehicle.
  /// @param along_m  about where on the route the vehicle is
  void take(std::span<const SeenEdge> seen, const Pose2& T_odom_vehicle, double along_m);

  /// The odometry has been corrected. Where edges have told the pose, it stays.
  void correct(const Pose2& T_odom_before, const Pose2& T_odom_now);

  const Pose2& T_map_odom() const { return T_map_odom_; }
  /// Whether the edges have been found to fit.
  bool is_sure() const { return fits_ > 0; }
  const TaughtEdges& taught() const { return taught_; }

 private:
  struct Fit {
    Pose2 T_map_vehicle;
    double fitting_share = 0;  ///< share of the points that lie on taught edges
  };

  /// Grows with the distance, as an image row covers more floor there.
  double variance_m2(const SeenEdge& seen) const;
  Pose2 most_alike(std::span<const SeenEdge> seen, const Pose2& T_map_expected) const;
  Fit refined(std::span<const SeenEdge> seen, const Pose2& T_map_begin, const Pose2& T_map_expected,
              double sigma_m, double sigma_rad) const;

  EdgePlaceParams params_;
  TaughtEdges taught_;
  Pose2 T_map_odom_;
  int fits_ = 0;  ///< images that have corrected the pose
};

}  // namespace aisle
