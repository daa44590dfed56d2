#pragma once

#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// By how much the way that the wheels count is too short or too long: the same share on the whole trip, as a
/// tyre's radius is. Learned as a fourth unknown of the pose's Kalman filter: what corrects the pose says of
/// the scale what their covariance says.
class OdometryScale {
 public:
  /// @param sigma  how far the factor may be off before anything was seen; 0: it is 1 and stays so
  explicit OdometryScale(double sigma) : variance_(sigma * sigma) {}

  /// The way of one step, as far as the scale is known.
  Pose2 true_step(const Pose2& counted) const {
    return {factor_ * counted.x, factor_ * counted.y, counted.theta};
  }

  /// The pose has moved by one step; its covariance grows by what the scale may be off.
  void predict(const Pose2& T_track_last, const Pose2& step, Mat3& pose_covariance);

  /// The pose was corrected by something that knows nothing of the scale.
  /// @param prior, posterior  its covariances, of (x, y, theta) in `track`
  void correct(const Mat3& prior, const Vec3& correction, const Mat3& posterior);

  /// The pose is known anew: how it came there says nothing.
  void forget_pose() { with_pose_.setZero(); }

  double factor() const { return factor_; }

 private:
  double factor_ = 1;
  double variance_;
  Vec3 with_pose_ = Vec3::Zero();  ///< covariance of the pose and the factor
};

}  // namespace aisle
