#pragma once

#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// A place in `track` that the vehicle came to, as far as nothing but its wheels given how far that was.
struct CountedPath {
  Vec2 by_factor = Vec2::Zero();  ///< the place moves by this for each unit of the scale's factor [m]
  Vec2 counted_m = Vec2::Zero();  ///< how much of that it was moved by already, by the factors of the time

  /// By how much it lies elsewhere, if this is the factor.
  Vec2 off_m(double factor) const { return factor * by_factor - counted_m; }
};

/// By how much the path that the wheels count is too short or too long: the same share on the whole run, as a
/// tyre's radius is. Learned as a fourth unknown of the pose's Kalman filter: what corrects the pose says of
/// the scale what their covariance says.
class OdometryScale {
 public:
  /// @param sigma  how far the factor may be off before anything was seen; 0: it is 1 and stays so
  explicit OdometryScale(double sigma) : variance_(sigma * sigma) {}

  /// The path of one step, as far as the scale is known.
  Pose2 true_step(const Pose2& counted) const {
    return {factor_ * counted.x, factor_ * counted.y, counted.theta};
  }

  /// The pose has moved by one step; its covariance grows by what the scale may be off.
  void predict(const Pose2& T_track_last, const Pose2& step, Mat3& pose_covariance);

  /// The pose was corrected by something that knows nothing of the scale.
  /// @param prior, posterior  its covariances, of (x, y, theta) in `track`
  void correct(const Mat3& prior, const Vec3& correction, const Mat3& posterior);

  /// From now on the pose, its covariance and what corrects it are meant as seen from something that stands
  /// where the vehicle came by such a path: wheels' distances that both have in common say nothing of how
  /// they lie to each other. What is known of the two, and path(), stay the same.
  /// @return how far the pose moves by that in `track`, where what is seen stands as it was laid [m]
  Vec2 refer_to(const CountedPath& seen, Mat3& pose_covariance);

  /// The pose is known again: how it came there says nothing.
  void forget_pose();

  double factor() const { return factor_; }
  /// To the pose. Nothing, where the scale is known to be 1.
  CountedPath path() const;

 private:
  double factor_ = 1;
  double variance_;
  Vec3 with_pose_ = Vec3::Zero();  ///< covariance of the pose, as seen from there, and the factor
  CountedPath path_there_;         ///< to what the pose is seen from
};

}  // namespace aisle
