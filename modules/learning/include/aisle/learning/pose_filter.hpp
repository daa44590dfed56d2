#pragma once
/// Where the vehicle is, by odometry and by what it sees, with an honest covariance.

#include <span>

#include "aisle/geometry/pose2.hpp"
#include "aisle/vehicle/observation.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// A point of the map that is seen.
struct SeenPoint {
  Vec2 p_map = Vec2::Zero();
  Vec2 p_vehicle = Vec2::Zero();
  Mat2 covariance = Mat2::Zero();  ///< of the two together, along the vehicle's axes, `by_tilt` excepted
  Vec2 by_tilt =
      Vec2::Zero();  ///< what a standard deviation of the image's common tilt error does to p_vehicle
};

/// A Gaussian estimate of the pose together with what is steadily wrong with the odometry: the scale of
/// paths, the scale of turns, and a turn that comes with every metre (a steering wheel off its zero). Such
/// errors add up in the pose by themselves; seen landmarks correct both.
class PoseFilter {
 public:
  static constexpr double kForgotten_per_m = 0.01;  ///< where nothing else is known of the wheels

  /// @param forgotten_per_m  how soon each of the steady errors may change: the share of its first variance
  ///                         that comes back with each metre
  PoseFilter(const VehicleDescription& vehicle, const UncertainPose2& T_map_vehicle,
             const Vec3& forgotten_per_m = Vec3::Constant(kForgotten_per_m));

  void predict(const OdometryReading& reading);

  /// Takes in the points of one image, all at once: the most probable pose by Gauss-Newton, points that
  /// stand out having less weight (Huber). `guess` is where the search begins.
  void update(std::span<const SeenPoint> points, const Pose2& guess);

  /// How badly the points fit what was predicted, both at the pose that `update` would take: the sum of the
  /// squares of all deviations, each in its standard deviations. If the points are what they are taken for,
  /// it is chi-squared distributed, with two degrees of freedom a point (Neira and Tardos 2001: joint
  /// compatibility).
  double squared_distance(std::span<const SeenPoint> points, const Pose2& guess) const;

  /// Takes in one number that is known to depend on the pose.
  /// @param off      how far the number that was measured is above the one expected by the pose
  /// @param by_pose  what a change of (x, y, theta) does to the one expected
  /// @return whether it was likely enough to be believed: within three standard deviations
  bool correct(double off, const Vec3& by_pose, double sigma);

  /// Puts the vehicle elsewhere; what is known of the odometry stays.
  void place(const UncertainPose2& T_map_vehicle);

  const Pose2& pose() const { return T_map_vehicle_; }
  /// Where the vehicle was at first, by all that was seen since then (fixed-point smoothing).
  const Pose2& first_pose() const { return T_map_first_; }
  Mat3 covariance() const { return covariance_.topLeftCorner<3, 3>(); }

 private:
  using Vec6 = Eigen::Matrix<double, 6, 1>;
  using Mat6 = Eigen::Matrix<double, 6, 6>;
  using Mat36 = Eigen::Matrix<double, 3, 6>;
  using Vec7 = Eigen::Matrix<double, 7, 1>;
  using Mat7 = Eigen::Matrix<double, 7, 7>;
  /// The most probable change of (x, y, theta, odometry errors) against the prediction, and the image's
  /// tilt error in standard deviations.
  struct Fit {
    Vec7 change = Vec7::Zero();
    Mat7 information = Mat7::Identity();
    double squared_distance = 0;
  };

  Fit fit(std::span<const SeenPoint> points, const Pose2& guess) const;

  VehicleDescription vehicle_;
  Vec3 forgotten_per_m_;
  Vec3 steady_variances_ = Vec3::Zero();  ///< of the odometry errors, before anything was seen
  Pose2 T_map_vehicle_;
  Vec3 odometry_errors_ = Vec3::Zero();  ///< path scale, turn scale, turn per metre [1/m]
  Mat6 covariance_ = Mat6::Zero();       ///< of (x, y, theta, odometry errors)
  Pose2 T_map_first_;
  Mat36 first_with_state_ = Mat36::Zero();  ///< covariance of the first pose with the present state
};

}  // namespace aisle
