#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "aisle/control/steering.hpp"
#include "aisle/guidance/navigator.hpp"
#include "aisle/vehicle/vehicle_description.hpp"
#include "aisle/vision/route/painted_frame.hpp"

namespace aisle {

struct FrameParkingParams {
  PaintedFrameParams frame;
  SteeringParams steering{.look_ahead_m = 0.25};
  double speed_mps = 0.15;
  double speed_min_mps = 0.03;
  double deceleration_mps2 = 0.05;
  double reverse_speed_mps = 0.15;
  double gain = 0.3;
  double lateral_max_m = 0.012;
  double turned_max_rad = 1 * kDegree;
  double misaligned_m = 0.05;
  double yaw_error_rad = 3 * kDegree;
  double judged_m = 0.35;
  double hopeless_m = 0.06;
  double back_off_m = 1.8;
  int tries_max = 3;
  double unseen_max_m = 1;
  double tracked_m = 0.5;

  void describe(FieldList& fields);
};

/// Parks a front-steered vehicle forwards in a painted square frame (L96 section 3.4): along the line through
/// the middles of its near and far side, which the second camera shows from far and the first from near.
/// Beyond the paper, odometry tracks the frame's pose, and each image corrects it. A vehicle that would stop
/// misaligned backs off and tries again; after the last try it fails if it still is.
class FrameParking {
 public:
  /// @param size_m  between the middles of the frame's lines, along the direction of entry and across
  FrameParking(const FrameParkingParams& params, const VehicleDescription& vehicle, const Vec2& size_m);

  /// Looks for the frame in every image of the cycle.
  /// @param T_odom_expected  expected pose of the frame, x along the direction of entry
  /// @param astray_m         a frame first seen farther from there is ignored
  void look(const Observation& observation, const Pose2& T_odom_vehicle, const Pose2& T_odom_expected,
            double astray_m);
  bool sees_frame() const { return T_odom_frame_.has_value(); }

  Decision step();

  const std::optional<Pose2>& frame() const { return T_odom_frame_; }
  const Vec2& size_m() const { return size_m_; }
  int tries() const { return tries_; }
  /// The vehicle's pose relative to its parking pose, by the frame as seen.
  Pose2 off() const;

 private:
  Pose2 T_odom_parked() const;
  void take(const Pose2& T_odom_seen);
  Decision approach();
  Decision back_off();
  Decision settle();

  FrameParkingParams params_;
  VehicleDescription vehicle_;
  Vec2 size_m_;
  PathFollower follower_;
  Pose2 T_odom_vehicle_;
  std::optional<Pose2> T_odom_frame_;
  Pose2 T_odom_found_;  ///< the frame as it was first seen
  double steering_rad_ = 0;
  double unseen_m_ = 0;  ///< path since the frame was last seen
  bool is_backing_ = false;
  int tries_ = 1;
};

}  // namespace aisle
