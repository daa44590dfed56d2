#include "aisle/learning/pose_filter.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "aisle/core/angle.hpp"
#include "aisle/core/square.hpp"
#include "aisle/geometry/pose_change.hpp"
#include "odometry_arc.hpp"

namespace aisle {
namespace {

constexpr double kLeastSigma = 1e-5;  // lower limit of all sigmas [m, rad]
constexpr double kHuber = 1.5;        // residuals beyond this many standard deviations count less
constexpr double kBelieved = 3;
constexpr int kRounds = 5;
constexpr double kPoseSettled = 1e-7;

}  // namespace

PoseFilter::PoseFilter(const VehicleDescription& vehicle, const UncertainPose2& T_map_vehicle,
                       const Vec3& forgotten_per_m)
    : vehicle_(vehicle), forgotten_per_m_(forgotten_per_m) {
  place(T_map_vehicle);
  steady_variances_ = steady_odometry_sigmas(vehicle).cwiseMax(kLeastSigma).cwiseAbs2();
  now_.covariance.bottomRightCorner<3, 3>() = steady_variances_.asDiagonal();
  now_.T_map_first = now_.T_map_vehicle;
  now_.first_with_state = now_.covariance.topRows<3>();
}

void PoseFilter::place(const UncertainPose2& T_map_vehicle) {
  now_.T_map_vehicle = T_map_vehicle.mean;
  now_.covariance.topRightCorner<3, 3>().setZero();
  now_.covariance.bottomLeftCorner<3, 3>().setZero();
  now_.covariance.topLeftCorner<3, 3>() = T_map_vehicle.covariance + Mat3::Identity() * square(kLeastSigma);
  now_.first_with_state.leftCols<3>().setZero();
  predictions_ = back_by_ = 0;
}

bool PoseFilter::go_back(int predictions) {
  const auto by = static_cast<std::size_t>(predictions);
  if (by > std::min(predictions_, kRemembered)) return false;
  back_by_ = by;
  if (by > 0) now_ = remembered(predictions_ - by).before;
  return true;
}

void PoseFilter::catch_up() {
  predictions_ -= back_by_;
  for (; back_by_ > 0; --back_by_) predict(OdometryReading(remembered(predictions_).reading));
}

void PoseFilter::predict(const OdometryReading& reading) {
  remembered(predictions_++) = {now_, reading};
  const UncertainArc read = uncertain_arc(vehicle_, reading);
  if (read.arc.length_m == 0 && read.arc.turn_rad == 0) return;
  const Arc arc{
      read.arc.length_m * (1 + now_.odometry_errors[0]),
      read.arc.turn_rad * (1 + now_.odometry_errors[1]) + read.arc.length_m * now_.odometry_errors[2]};
  Eigen::Matrix<double, 2, 3> by_errors;
  by_errors << read.arc.length_m, 0, 0,  //
      0, read.arc.turn_rad, read.arc.length_m;

  const Pose2 moved = end_pose(arc);
  const double c = std::cos(now_.T_map_vehicle.theta), s = std::sin(now_.T_map_vehicle.theta);
  Mat3 by_pose = Mat3::Identity();
  by_pose(0, 2) = -s * moved.x - c * moved.y;
  by_pose(1, 2) = c * moved.x - s * moved.y;
  Mat3 turned = Mat3::Identity();
  turned.topLeftCorner<2, 2>() << c, -s, s, c;
  const Mat32 by_arc = turned * end_pose_jacobian(arc);

  Mat6 by_state = Mat6::Identity();
  by_state.topLeftCorner<3, 3>() = by_pose;
  by_state.topRightCorner<3, 3>() = by_arc * by_errors;
  now_.covariance = by_state * now_.covariance * by_state.transpose();
  now_.first_with_state = now_.first_with_state * by_state.transpose();
  now_.covariance.topLeftCorner<3, 3>() += by_arc * read.covariance * by_arc.transpose();
  now_.covariance.diagonal().tail<3>() +=
      (forgotten_per_m_ * std::abs(arc.length_m)).cwiseProduct(steady_variances_);
  now_.T_map_vehicle = now_.T_map_vehicle * moved;
}

bool PoseFilter::correct(double off, const Vec3& by_pose, double sigma) {
  Vec6 by_state = Vec6::Zero();
  by_state.head<3>() = by_pose;
  const Vec6 with_state = now_.covariance * by_state;
  const double variance = by_state.dot(with_state) + square(sigma);
  if (square(off) > square(kBelieved) * variance) return false;
  const Vec3 first_with = now_.first_with_state * by_state;
  const Vec6 change = with_state * off / variance;
  now_.covariance -= with_state * with_state.transpose() / variance;
  now_.first_with_state -= first_with * with_state.transpose() / variance;
  now_.T_map_vehicle = moved_by(now_.T_map_vehicle, change.head<3>());
  now_.odometry_errors += change.tail<3>();
  now_.T_map_first = moved_by(now_.T_map_first, first_with * off / variance);
  return true;
}

void PoseFilter::update(std::span<const SeenPoint> points, const Pose2& guess) {
  if (points.empty()) return;
  const Fit found = fit(points, guess);
  const Mat7 posterior = found.information.llt().solve(Mat7::Identity());
  const Mat36 first_by_state = now_.covariance.llt().solve(now_.first_with_state.transpose()).transpose();
  now_.covariance = posterior.topLeftCorner<6, 6>();
  now_.first_with_state = first_by_state * now_.covariance;
  now_.T_map_vehicle = moved_by(now_.T_map_vehicle, found.change.head<3>());
  now_.odometry_errors += found.change.segment<3>(3);
  now_.T_map_first = moved_by(now_.T_map_first, first_by_state * found.change.head<6>());
}

double PoseFilter::squared_distance(std::span<const SeenPoint> points, const Pose2& guess) const {
  return fit(points, guess).squared_distance;
}

PoseFilter::Fit PoseFilter::fit(std::span<const SeenPoint> points, const Pose2& guess) const {
  Mat7 prior = Mat7::Identity();
  prior.topLeftCorner<6, 6>() = now_.covariance.llt().solve(Mat6::Identity());
  Fit fit;
  fit.change.head<3>() = change_between(now_.T_map_vehicle, guess);
  for (int round = 0; round < kRounds; ++round) {
    fit.information = prior;
    fit.squared_distance = fit.change.dot(prior * fit.change);
    Vec7 slope = -prior * fit.change;
    const double theta = now_.T_map_vehicle.theta + fit.change[2];
    const double c = std::cos(theta), s = std::sin(theta);
    for (const SeenPoint& point : points) {
      const Vec2 from = point.p_map - now_.T_map_vehicle.position() - fit.change.head<2>();
      const Vec2 expected{c * from.x() + s * from.y(), -s * from.x() + c * from.y()};
      const Vec2 residual = point.p_vehicle - point.by_tilt * fit.change[6] - expected;
      Eigen::Matrix<double, 2, 7> by_change = Eigen::Matrix<double, 2, 7>::Zero();
      by_change.block<2, 2>(0, 0) << -c, -s, s, -c;
      by_change.col(2) << expected.y(), -expected.x();
      by_change.col(6) = point.by_tilt;
      const Mat2 weight = point.covariance.inverse();
      const double squared_distance = residual.dot(weight * residual);
      fit.squared_distance += squared_distance;
      const double share = squared_distance > square(kHuber) ? kHuber / std::sqrt(squared_distance) : 1;
      fit.information += share * by_change.transpose() * weight * by_change;
      slope += share * by_change.transpose() * weight * residual;
    }
    const Vec7 step = fit.information.llt().solve(slope);
    fit.change += step;
    if (step.cwiseAbs().maxCoeff() < kPoseSettled) break;
  }
  return fit;
}

}  // namespace aisle
