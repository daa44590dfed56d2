#include "mwght_refinement.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "aisle/core/median.hpp"
#include "aisle/core/square.hpp"

namespace aisle {
namespace {

constexpr int kRounds = 12;
constexpr double kSettled = 1e-7;          // [m, rad]: further rounds change nothing
constexpr double kNoiseMin_m = 0.004;      // least estimated noise of a coordinate
constexpr double kNoiseGuess_m = 0.03;     // guessed noise of a pair's coordinate at first,
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
  /// How many pairs of equal weight would say as much.
  double pairs() const { return weight * weight / squared_weight; }
};

}  // namespace

void MwghtRefinement::pair_within_reach(const Pose2& start, std::span<const WeightedPoint> learned,
                                        std::span<const WeightedPoint> seen) {
  pairs_.clear();
  const double reach_m2 = square(params_.reach_m + params_.cell_m);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const Vec2 moved = rotate(start.theta, seen[i].position) + start.position();
    for (const WeightedPoint& p : learned) {
      if ((p.position - moved).squaredNorm() > reach_m2) continue;
      pairs_.push_back({i, p.position, seen[i].position, p.weight * seen[i].weight});
    }
  }
}

void MwghtRefinement::match_nearest(const Pose2& displacement) {
  matches_.clear();
  const Vec2 forward = unit(displacement.theta);
  std::size_t last_seen = 0;
  for (const Pair& pair : pairs_) {
    const Vec2 lever = pair.p_seen.x() * forward + pair.p_seen.y() * left_normal(forward);
    const Vec2 residual = lever + displacement.position() - pair.p_learned;
    const Match match{lever, residual, pair.weight, residual.norm()};
    if (matches_.empty() || pair.seen != last_seen) {
      matches_.push_back(match);
    } else if (match.distance_m < matches_.back().distance_m) {
      matches_.back() = match;
    }
    last_seen = pair.seen;
  }
}

double MwghtRefinement::usual_distance() {
  distances_.clear();
  for (const Match& match : matches_) distances_.push_back(match.distance_m);
  return median_reordering(std::span(distances_));
}

UncertainPose2 MwghtRefinement::refine(const MwghtCell& cell, std::span<const WeightedPoint> learned,
                                       std::span<const WeightedPoint> seen, const MwghtWindow& window) {
  Pose2 pose{cell.x * params_.cell_m, cell.y * params_.cell_m, cell.turn * params_.angle_step_rad};
  const double near_m = params_.reach_m + params_.cell_m;
  const Vec3 window_variance(square(window.x_half_m + near_m), square(window.y_half_m + near_m),
                             square(window.turn_half_rad + params_.angle_step_rad));
  const Mat3 window_information = window_variance.cwiseInverse().asDiagonal();
  Mat3 covariance = window_variance.asDiagonal();
  pair_within_reach(pose, learned, seen);
  if (pairs_.empty()) return {pose, covariance};
  for (int round = 0; round < kRounds; ++round) {
    match_nearest(pose);
    const double noise_m = std::max(kNoiseMin_m, usual_distance() / kMedianDistance);
    Normal normal;
    for (const Match& match : matches_) {
      const double robust = std::exp(-square(match.distance_m / (kWelschSigmas * noise_m)) / 2);
      normal.add(match.lever, match.residual, robust * match.weight);
    }
    const double as_pairs = normal.pairs() / normal.weight;
    const double variance_m2 =
        (kNoiseGuessWorth * square(kNoiseGuess_m) + as_pairs * normal.squared_residual) /
        (2 * normal.pairs());
    const double worth = as_pairs / variance_m2;
    const Mat3 information = worth * normal.information + window_information;
    covariance = information.inverse();
    const Vec3 step = -worth * covariance * normal.gradient;
    pose = {pose.x + step.x(), pose.y + step.y(), pose.theta + step.z()};
    if (step.norm() < kSettled) break;
  }
  return {pose, covariance};
}

}  // namespace aisle
