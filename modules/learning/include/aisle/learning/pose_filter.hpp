#pragma once
/// The vehicle's pose from odometry and observations, with a consistent covariance.

#include <array>
#include <cstddef>
#include <span>

#include "aisle/geometry/pose2.hpp"
#include "aisle/vehicle/observation.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// An observed point of the map.
struct SeenPoint {
  Vec2 p_map = Vec2::Zero();
  Vec2 p_vehicle = Vec2::Zero();
  Mat2 covariance = Mat2::Zero();  ///< of both positions combined, in the vehicle's axes, without `by_tilt`
  Vec2 by_tilt =
      Vec2::Zero();  ///< shift of p_vehicle by one standard deviation of the image's common tilt error
};

/// A Gaussian estimate of the pose together with the systematic odometry errors: the scale of distances, the
/// scale of turns, and a turn per metre (steering off its zero). Their effect accumulates in the pose;
/// observations correct both.
class PoseFilter {
 public:
  static constexpr double kForgotten_per_m = 0.01;  ///< used where nothing else is known about the wheels

  /// @param forgotten_per_m  how fast each systematic error may change: the share of its initial variance
  ///                         that comes back with each metre
  PoseFilter(const VehicleDescription& vehicle, const UncertainPose2& T_map_vehicle,
             const Vec3& forgotten_per_m = Vec3::Constant(kForgotten_per_m));

  void predict(const OdometryReading& reading);

  /// Updates with all points of one image at once: the most probable pose by Gauss-Newton, with outliers
  /// weighted down (Huber).
  /// @param guess  where the search begins
  void update(std::span<const SeenPoint> points, const Pose2& guess);

  /// How badly the points fit the prediction, at the pose that `update` would take: the sum of all squared
  /// deviations, each in its standard deviations. If the associations are right, it is chi-squared
  /// distributed with two degrees of freedom a point (Neira and Tardos 2001: joint compatibility).
  double squared_distance(std::span<const SeenPoint> points, const Pose2& guess) const;

  /// Updates with one scalar measurement that depends on the pose.
  /// @param off      measured less predicted value
  /// @param by_pose  derivative of the predicted value by (x, y, theta)
  /// @return whether it was accepted: within three standard deviations
  bool correct(double off, const Vec3& by_pose, double sigma);

  /// Goes back by some predictions, to take in what was seen then; `catch_up` predicts them again. What was
  /// corrected in between is forgotten: observations come in the order in which they were made.
  /// @return false, and nothing happens, if it was placed since, or remembers no more
  bool go_back(int predictions);
  void catch_up();

  /// Moves the estimate to a new pose; the odometry errors are kept.
  void place(const UncertainPose2& T_map_vehicle);

  const Pose2& pose() const { return now_.T_map_vehicle; }
  /// The first pose, given all observations since then (fixed-point smoothing).
  const Pose2& first_pose() const { return now_.T_map_first; }
  Mat3 covariance() const { return now_.covariance.topLeftCorner<3, 3>(); }

 private:
  using Vec6 = Eigen::Matrix<double, 6, 1>;
  using Mat6 = Eigen::Matrix<double, 6, 6>;
  using Mat36 = Eigen::Matrix<double, 3, 6>;
  using Vec7 = Eigen::Matrix<double, 7, 1>;
  using Mat7 = Eigen::Matrix<double, 7, 7>;
  /// The most probable change of (x, y, theta, odometry errors) against the prediction, and the image's tilt
  /// error in standard deviations.
  struct Fit {
    Vec7 change = Vec7::Zero();
    Mat7 information = Mat7::Identity();
    double squared_distance = 0;
  };

  struct Estimate {
    Pose2 T_map_vehicle;
    Vec3 odometry_errors = Vec3::Zero();  ///< path scale, turn scale, turn per metre [1/m]
    Mat6 covariance = Mat6::Zero();       ///< of (x, y, theta, odometry errors)
    Pose2 T_map_first;
    Mat36 first_with_state = Mat36::Zero();  ///< covariance of the first pose with the current state
  };
  struct Prediction {
    Estimate before;
    OdometryReading reading;
  };
  static constexpr std::size_t kRemembered = 64;

  Prediction& remembered(std::size_t prediction) { return recent_[prediction % kRemembered]; }
  Fit fit(std::span<const SeenPoint> points, const Pose2& guess) const;

  VehicleDescription vehicle_;
  Vec3 forgotten_per_m_;
  Vec3 steady_variances_ = Vec3::Zero();  ///< of the odometry errors, before anything was seen
  Estimate now_;
  std::array<Prediction, kRemembered> recent_;
  std::size_t predictions_ = 0;  ///< since it was placed
  std::size_t back_by_ = 0;
};

}  // namespace aisle
