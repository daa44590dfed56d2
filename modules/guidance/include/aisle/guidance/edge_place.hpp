#pragma once

#include <span>
#include <vector>

#include "aisle/core/parameters.hpp"
#include "aisle/geometry/pose2.hpp"
#include "aisle/guidance/taught_edges.hpp"

namespace aisle {

struct EdgePlaceParams {
  double window_m = 4;
  double reach_m = 0.3;
  double deviation_m = 0.05;
  double far_m = 2.5;
  double set_down_m = 0.35;
  double set_down_rad = 12 * kDegree;
  double drift_m = 0.03;
  double drift_rad = 1 * kDegree;
  int points_min = 20;
  double fitting_min = 0.5;
  double gain = 0.3;

  void describe(FieldList& fields);
};

/// Tells by the edges of the route, as far as they are where they were taught, where the vehicle is: the
/// first picture is laid onto them from all poses about the one at which the vehicle was set down, the later
/// ones from where the odometry expects them. What stands otherwise than at teaching counts the less the
/// farther off it is.
class EdgePlace {
 public:
  /// @param taught  may be empty: then `map` stays `odom`
  EdgePlace(const EdgePlaceParams& params, const std::vector<RouteEdge>& taught);

  /// Looks up the edges of the way about there, for `taught` and `take`.
  void come_to(const Pose2& T_odom_vehicle, double along_m);
  /// Takes in the edges that a picture shows.
  /// @param along_m  about where on the route the vehicle is
  void take(std::span<const Vec2> p_vehicle, const Pose2& T_odom_vehicle, double along_m);

  const Pose2& T_map_odom() const { return T_map_odom_; }
  /// The edges have been found to fit.
  bool is_sure() const { return is_sure_; }
  const TaughtEdges& taught() const { return taught_; }

 private:
  struct Fit {
    Pose2 T_map_vehicle;
    double fitting_share = 0;  ///< of the points that lie on edges
  };

  /// Of an edge that is seen there: one picture row is the more floor, the farther away it is.
  double variance_m2(const Vec2& p_vehicle) const;
  Pose2 most_alike(std::span<const Vec2> p_vehicle, const Pose2& T_map_expected) const;
  Fit refined(std::span<const Vec2> p_vehicle, const Pose2& T_map_begin, const Pose2& T_map_expected,
              double sigma_m, double sigma_rad) const;

  EdgePlaceParams params_;
  TaughtEdges taught_;
  Pose2 T_map_odom_;
  bool is_sure_ = false;
};

}  // namespace aisle
