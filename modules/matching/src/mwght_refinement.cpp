#include "mwght_refinement.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "aisle/core/square.hpp"

namespace aisle {
namespace {

constexpr int kRounds = 20;
constexpr double kSettled = 1e-10;         // [m, rad]: further rounds change nothing
constexpr double kNoiseMin_m = 0.004;      // floor of the estimated noise of a coordinate
constexpr double kNoiseGuess_m = 0.03;     // of a pair's coordinate, before anything is known,
constexpr double kNoiseGuessWorth = 3;     // and how many residuals this guess is worth
constexpr double kMedianDistance = 1.177;  // of points with a noise of 1 in both coordinates
constexpr double kWelschSigmas = 3;

/// Weighted least squares about a pose: information and right-hand side of the step.
struct Normal {
  Mat3 information = Mat3::Zero();
  Vec3 gradient = Vec3::Zero();
  double weight = 0, squared_weight = 0, squared_residual = 0;

  void add(const Vec2& lever, const Vec2& residual, double w) {
    Eigen::Matrix<double, 2, 3> jacobian;
    jacobian << Mat2::Identity(), left_normal(lever);
    information += w * jacobian.transpose() * jacobian;
    gradient += w * jacobian.transpose() * residual;
    weight += w;
    squared_weight += w * w;
    squared_residual += w * residual.squaredNorm();
  }
  /// How many equal pairs would say as much.
  double pairs() const { return weight * weight / squared_weight; }
};

}  // namespace

void MwghtRefinement::pair_nearest(const Pose2& displacement, std::span<const WeightedPoint> learned,
                                   std::span<const WeightedPoint> seen) {
  pairs_.clear();
  const double reach_m = params_.reach_m + params_.cell_m;
  const Vec2 forward = unit(displacement.theta);
  for (const WeightedPoint& q : seen) {
    const Vec2 moved =
        q.position.x() * forward + q.position.y() * left_normal(forward) + displacement.position();
    const WeightedPoint* nearest = nullptr;
    double nearest_m2 = square(reach_m);
    for (const WeightedPoint& p : learned) {
      const double m2 = (p.position - moved).squaredNorm();
      if (m2 > nearest_m2) continue;
      nearest_m2 = m2;
      nearest = &p;
    }
    if (nearest)
      pairs_.push_back({nearest->position, q.position, nearest->weight * q.weight, std::sqrt(nearest_m2)});
  }
}

double MwghtRefinement::usual_distance() {
  distances_.clear();
  for (const Pair& pair : pairs_) distances_.push_back(pair.distance_m);
  const auto middle = distances_.begin() + static_cast<std::ptrdiff_t>(distances_.size() / 2);
  std::nth_element(distances_.begin(), middle, distances_.end());
  return *middle;
}

UncertainPose2 MwghtRefinement::refine(const MwghtCell& cell, std::span<const WeightedPoint> learned,
                                       std::span<const WeightedPoint> seen, const MwghtWindow& window) {
  const Pose2 start{cell.x * params_.cell_m, cell.y * params_.cell_m, cell.turn * params_.angle_step_rad};
  const Vec3 window_variance(square(window.x_half_m + params_.reach_m),
                             square(window.y_half_m + params_.reach_m),
                             square(window.turn_half_rad + params_.angle_step_rad));
  const Mat3 window_information = window_variance.cwiseInverse().asDiagonal();
  Pose2 pose = start;
  Mat3 covariance = window_variance.asDiagonal();
  for (int round = 0; round < kRounds; ++round) {
    pair_nearest(pose, learned, seen);
    if (pairs_.empty()) break;
    const double noise_m = std::max(kNoiseMin_m, usual_distance() / kMedianDistance);
    Normal normal;
    for (const Pair& pair : pairs_) {
      const double robust = std::exp(-square(pair.distance_m / (kWelschSigmas * noise_m)) / 2);
      const Vec2 lever = rotate(pose.theta, pair.p_seen);
      normal.add(lever, lever + pose.position() - pair.p_learned, robust * pair.weight);
    }
    const double as_pairs = normal.pairs() / normal.weight;
    const double variance_m2 =
        (kNoiseGuessWorth * square(kNoiseGuess_m) + as_pairs * normal.squared_residual) /
        (2 * normal.pairs());
    const Vec3 from_start(pose.x - start.x, pose.y - start.y, pose.theta - start.theta);
    const Mat3 information = as_pairs / variance_m2 * normal.information + window_information;
    const Vec3 step =
        -information.ldlt().solve(as_pairs / variance_m2 * normal.gradient + window_information * from_start);
    covariance = information.inverse();
    pose = {pose.x + step.x(), pose.y + step.y(), pose.theta + step.z()};
    if (step.norm() < kSettled) break;
  }
  return {pose, covariance};
}

}  // namespace aisle
