#pragma once

#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// A position in `track` that the vehicle reached, as a function of the wheels' scale factor.
struct CountedPath {
  Vec2 by_factor = Vec2::Zero();  ///< derivative of the position by the scale factor [m]
  Vec2 counted_m = Vec2::Zero();  ///< the part already applied, with the factors known at the time

  /// Correction of the position for this factor [m].
  Vec2 off_m(double factor) const { return factor * by_factor - counted_m; }
};

/// Scale error of the distances that the wheels count: a constant factor over the whole run, like a tyre's
/// radius. It is a fourth unknown of the pose's Kalman filter: what corrects the pose corrects the factor as
/// far as they are correlated.
class OdometryScale {
 public:
  /// @param sigma  initial standard deviation of the factor; 0: it is 1 and stays 1
  explicit OdometryScale(double sigma) : variance_(sigma * sigma) {}

  /// The motion of one step, scaled by the current factor.
  Pose2 true_step(const Pose2& counted) const {
    return {factor_ * counted.x, factor_ * counted.y, counted.theta};
  }

  /// Call this when the pose has moved by one step; adds the uncertainty of the scale to its covariance.
  void predict(const Pose2& T_track_last, const Pose2& step, Mat3& pose_covariance);

  /// Call this when the pose was corrected by something independent of the scale.
  /// @param prior, posterior  covariances of the pose, of (x, y, theta) in `track`
  void correct(const Mat3& prior, const Vec3& correction, const Mat3& posterior);

  /// From now on the pose, its covariance and its corrections are relative to something seen from a position
  /// with this counted path: distances that both share say nothing about their relative position. What is
  /// known of both, and path(), stay the same.
  /// @return how far that moves the pose in `track`, with what is seen kept in place [m]
  Vec2 refer_to(const CountedPath& seen, Mat3& pose_covariance);

  /// The pose is known from elsewhere: how it came there says nothing about the factor.
  void forget_pose();

  double factor() const { return factor_; }
  /// Counted path to the pose; zero if the scale is known to be 1.
  CountedPath path() const;

 private:
  double factor_ = 1;
  double variance_;
  Vec3 with_pose_ = Vec3::Zero();  ///< covariance of the pose, relative to the reference, and the factor
  CountedPath path_there_;         ///< counted path to that reference
};

}  // namespace aisle
