#pragma once

#include <optional>

#include "aisle/guidance/navigator.hpp"
#include "aisle/maps/room_route.hpp"
#include "aisle/vehicle/vehicle_description.hpp"
#include "aisle/vision/route/route_corner.hpp"
#include "aisle/vision/route/route_view.hpp"

namespace aisle {

struct CornerBackingParams {
  bool by_corner = true;
  RouteCornerParams corner;
  double steering_rad = 10 * kDegree;
  double speed_mps = 0.15;
  double least_share = 0.5;
  double most_share = 1.3;
  double agree_m = 0.15;
  int images = 3;

  void describe(FieldList& fields);
};

/// Reverses between two turnings that are too close together for the vehicle (L96 section 3.3). The wheels
/// are turned to the right before a left turning and to the left before any other, until the third camera
/// shows the corner of the route around which the second turning leads. Beyond the paper, several images in a
/// row must show the corner at one place, only after a good part of the taught reverse path; and the vehicle
/// reverses hardly farther than it was taught.
class CornerBacking {
 public:
  /// @throws std::invalid_argument if the vehicle lacks the camera `bottom`
  CornerBacking(const CornerBackingParams& params, const RouteViewParams& view,
                const VehicleDescription& vehicle);

  /// The vehicle begins to reverse here.
  /// @param next      class of the second turning
  /// @param taught_m  length of the taught reverse path
  void begin(TurningClass next, double taught_m, const Pose2& T_odom_vehicle);
  void look(const Observation& observation, const Pose2& T_odom_vehicle);

  /// Steering angle while reversing.
  double requested_steering_rad() const;
  /// Whether it has reversed far enough.
  bool is_done(const Pose2& T_odom_vehicle) const;
  bool has_seen_corner() const { return images_ >= params_.images; }
  const std::optional<Vec2>& p_odom_corner() const { return p_odom_corner_; }

 private:
  double backed_m(const Pose2& T_odom_vehicle) const;

  CornerBackingParams params_;
  VehicleDescription vehicle_;
  CameraDescription camera_;
  RouteView view_;
  RouteSide side_ = RouteSide::kLeft;
  double taught_m_ = 0;
  Pose2 T_odom_begin_;
  std::optional<Vec2> p_odom_corner_;  ///< where the last image showed it
  int images_ = 0;                     ///< images in a row that showed it there
};

}  // namespace aisle
