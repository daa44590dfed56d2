#include "aisle/learning/walls/odometry_scale.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

namespace aisle {
namespace {

constexpr double kFactorOffMax = 0.1;  // larger errors have another cause

}  // namespace

void OdometryScale::predict(const Pose2& T_track_last, const Pose2& step, Mat3& pose_covariance) {
  const Vec2 moved = rotate(T_track_last.theta, step.position());
  Mat3 by_pose = Mat3::Identity();
  by_pose.topRightCorner<2, 1>() = left_normal(moved);
  Vec3 by_factor = Vec3::Zero();
  by_factor.head<2>() = moved / factor_;

  with_pose_ = (by_pose * with_pose_).eval();
  pose_covariance += with_pose_ * by_factor.transpose() + by_factor * with_pose_.transpose() +
                     variance_ * by_factor * by_factor.transpose();
  with_pose_ += variance_ * by_factor;
}

void OdometryScale::correct(const Mat3& prior, const Vec3& correction, const Mat3& posterior) {
  const Vec3 gain = prior.ldlt().solve(with_pose_);
  factor_ = std::clamp(factor_ + gain.dot(correction), 1 - kFactorOffMax, 1 + kFactorOffMax);
  variance_ -= gain.dot(with_pose_ - posterior * gain);
  with_pose_ = posterior * gain;
}

Vec2 OdometryScale::refer_to(const CountedPath& seen, Mat3& pose_covariance) {
  if (variance_ == 0) return Vec2::Zero();
  Vec2 moves_m = path_there_.off_m(factor_) - seen.off_m(factor_);
  Vec3 between = Vec3::Zero();
  between.head<2>() = path_there_.by_factor - seen.by_factor;
  pose_covariance += with_pose_ * between.transpose() + between * with_pose_.transpose() +
                     variance_ * between * between.transpose();
  with_pose_ += variance_ * between;
  path_there_ = seen;
  return moves_m;
}

void OdometryScale::forget_pose() {
  path_there_ = path();
  with_pose_.setZero();
}

CountedPath OdometryScale::path() const {
  if (variance_ == 0) return path_there_;
  const Vec2 on = with_pose_.head<2>() / variance_;
  return {path_there_.by_factor + on, path_there_.counted_m + factor_ * on};
}

}  // namespace aisle
