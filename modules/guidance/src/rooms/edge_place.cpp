#include "aisle/guidance/rooms/edge_place.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "aisle/core/square.hpp"
#include "aisle/geometry/pose_change.hpp"

namespace aisle {
namespace {

/// The errors of neighbouring points are correlated: this many of them count as one.
constexpr double kAlikePoints = 4;

/// Normal equations for a small change of a pose (x and y in `map`, heading) and for the displacement of each
/// taught side.
class PoseEquations {
 public:
  PoseEquations(const Pose2& T_map_vehicle, std::size_t sides)
      : T_map_vehicle_(T_map_vehicle), sides_(sides) {}

  void add_prior(const Pose2& T_map_expected, double sigma_m, double sigma_rad) {
    add({1, 0, 0}, T_map_vehicle_.x - T_map_expected.x, 1 / square(sigma_m));
    add({0, 1, 0}, T_map_vehicle_.y - T_map_expected.y, 1 / square(sigma_m));
    add({0, 0, 1}, wrap_angle(T_map_vehicle_.theta - T_map_expected.theta), 1 / square(sigma_rad));
  }
  /// A point of a side: its distance `off_m` along `n` from the taught edge should vanish.
  void add_point(int side, const Vec2& p_vehicle, const Vec2& n, double off_m, double weight) {
    const Vec2 lever = left_normal(rotate(T_map_vehicle_.theta, p_vehicle));
    const Vec3 by(n.x(), n.y(), n.dot(lever));
    add(by, off_m, weight);
    Side& of = sides_[static_cast<std::size_t>(side)];
    of.with_pose -= weight * by * n.transpose();
    of.normal += weight * n * n.transpose();
    of.right += weight * off_m * n;
  }
  /// The pose that fits best.
  /// @param deviation_m  displacement expected of a side 1 m long; longer ones are displaced less
  /// @param p_moved      displacement of each side; updated, too
  Pose2 moved(double deviation_m, const std::vector<double>& lengths_m, std::vector<Vec2>& p_moved) const {
    Mat3 normal = normal_;
    Vec3 right = right_;
    std::vector<Side> sides = sides_;
    for (std::size_t i = 0; i < sides.size(); ++i) {
      Side& side = sides[i];
      if (side.normal.isZero()) continue;
      // Cauchy: most objects are where they were, and a few are far off.
      const double weight = lengths_m[i] / (square(deviation_m) + p_moved[i].squaredNorm());
      side.normal += weight * Mat2::Identity();
      side.right -= weight * p_moved[i];
      const Mat2 inverse = side.normal.inverse();
      normal -= side.with_pose * inverse * side.with_pose.transpose();
      right -= side.with_pose * inverse * side.right;
    }
    const Vec3 step = normal.ldlt().solve(right);
    for (std::size_t i = 0; i < sides.size(); ++i) {
      if (sides[i].normal.isZero()) continue;
      p_moved[i] += sides[i].normal.inverse() * (sides[i].right - sides[i].with_pose.transpose() * step);
    }
    return moved_by(T_map_vehicle_, step);
  }

 private:
  struct Side {
    Eigen::Matrix<double, 3, 2> with_pose = Eigen::Matrix<double, 3, 2>::Zero();
    Mat2 normal = Mat2::Zero();
    Vec2 right = Vec2::Zero();
  };

  void add(const Vec3& by, double off, double weight) {
    normal_ += weight * by * by.transpose();
    right_ -= weight * off * by;
  }

  Pose2 T_map_vehicle_;
  Mat3 normal_ = Mat3::Zero();
  Vec3 right_ = Vec3::Zero();
  std::vector<Side> sides_;
};

}  // namespace

void EdgePlaceParams::describe(FieldList& fields) {
  fields.real("window_m", window_m, {0.5, 50},
              "only edges taught within this path before or beyond the vehicle count");
  fields.real("reach_m", reach_m, {0.05, 1}, "edges farther apart than this do not match");
  fields.real("deviation_m", deviation_m, {0.005, 1}, "standard deviation of a seen edge's position");
  fields.real("far_m", far_m, {0.5, 20}, "beyond, that grows with the square of the distance");
  fields.real("moved_m", moved_m, {0.001, 1}, "by which an object 1 m long may have been moved since");
  fields.real("set_down_m", set_down_m, {0.01, 2}, "standard deviation of the initial position");
  fields.angle("set_down_deg", set_down_rad, {0.5, 60}, "standard deviation of the initial heading");
  fields.real("drift_m", drift_m, {0.001, 1},
              "standard deviation of the odometry's position, against one image");
  fields.angle("drift_deg", drift_rad, {0.05, 30}, "standard deviation of the odometry's heading");
  fields.count("points_min", points_min, {3, 10'000}, "fewer edges are not used");
  fields.real("fitting_min", fitting_min, {0, 1}, "share of the edges that must be where they were taught");
  fields.real("gain", gain, {0, 1}, "how much one image corrects the pose; 0: odometry alone");
}

EdgePlace::EdgePlace(const EdgePlaceParams& params, const std::vector<RouteEdge>& taught)
    : params_(params), taught_(taught, params.reach_m) {}

void EdgePlace::come_to(const Pose2& T_odom_vehicle, double along_m) {
  taught_.move_to(along_m, params_.window_m, (T_map_odom_ * T_odom_vehicle).position());
}

void EdgePlace::take(std::span<const SeenEdge> seen, const Pose2& T_odom_vehicle, double along_m) {
  if (seen.size() < static_cast<std::size_t>(params_.points_min)) return;
  const Pose2 T_map_expected = T_map_odom_ * T_odom_vehicle;
  come_to(T_odom_vehicle, along_m);
  // The first images may mislead; after many, the odometry is trusted more than any single one.
  const double share = 1.0 / std::max(1, fits_);
  const double sigma_m = std::max(params_.drift_m, share * params_.set_down_m);
  const double sigma_rad = std::max(params_.drift_rad, share * params_.set_down_rad);
  const Pose2 T_map_begin = is_sure() ? T_map_expected : most_alike(seen, T_map_expected);
  const Fit fit = refined(seen, T_map_begin, T_map_expected, sigma_m, sigma_rad);
  if (fit.fitting_share < params_.fitting_min) return;
  const double gain = is_sure() ? params_.gain : 1;
  const Pose2 T_map_vehicle = interpolate(T_map_expected, fit.T_map_vehicle, gain);
  T_map_odom_ = T_map_vehicle * T_odom_vehicle.inverse();
  ++fits_;
}

void EdgePlace::correct(const Pose2& T_odom_before, const Pose2& T_odom_now) {
  if (is_sure()) T_map_odom_ = T_map_odom_ * T_odom_before * T_odom_now.inverse();
}

double EdgePlace::variance_m2(const SeenEdge& seen) const {
  return square(params_.deviation_m * std::max(1.0, square(seen.seen_from_m / params_.far_m)));
}

/// Tries a grid of poses around the expected one.
Pose2 EdgePlace::most_alike(std::span<const SeenEdge> seen, const Pose2& T_map_expected) const {
  constexpr double kStep_m = 0.1, kTurn_rad = 2 * kDegree, kReach = 2;  // deviations
  const int steps = static_cast<int>(kReach * params_.set_down_m / kStep_m);
  const int turns = static_cast<int>(kReach * params_.set_down_rad / kTurn_rad);
  Pose2 best = T_map_expected;
  double least = -1;
  for (int k = -turns; k <= turns; ++k) {
    const double turned_rad = k * kTurn_rad;
    std::vector<Vec2> p_turned;
    p_turned.reserve(seen.size());
    for (const SeenEdge& one : seen)
      p_turned.push_back(rotate(T_map_expected.theta + turned_rad, one.p_vehicle));
    for (int i = -steps; i <= steps; ++i) {
      for (int j = -steps; j <= steps; ++j) {
        const Vec2 p_map_vehicle = T_map_expected.position() + Vec2(i * kStep_m, j * kStep_m);
        double cost = square(turned_rad / params_.set_down_rad) +
                      (p_map_vehicle - T_map_expected.position()).squaredNorm() / square(params_.set_down_m);
        for (std::size_t n = 0; n < seen.size() && (least < 0 || cost < least); ++n) {
          const Vec2 p_map = p_map_vehicle + p_turned[n];
          const TaughtEdges::Edge* edge = taught_.nearest(p_map);
          const double off2_m2 = edge == nullptr
                                     ? square(params_.reach_m)
                                     : std::min((p_map - edge->p_map).squaredNorm(), square(params_.reach_m));
          cost += off2_m2 / (kAlikePoints * variance_m2(seen[n]));
        }
        if (least >= 0 && cost >= least) continue;
        least = cost;
        best = {p_map_vehicle.x(), p_map_vehicle.y(), wrap_angle(T_map_expected.theta + turned_rad)};
      }
    }
  }
  return best;
}

/// Gauss-Newton with Cauchy weights on the distances to the lines of the taught edges, or to the edges
/// themselves, each side with its displacement.
EdgePlace::Fit EdgePlace::refined(std::span<const SeenEdge> seen, const Pose2& T_map_begin,
                                  const Pose2& T_map_expected, double sigma_m, double sigma_rad) const {
  constexpr int kIterations = 8;
  constexpr double kFitting = 2;  // deviations
  Fit fit{.T_map_vehicle = T_map_begin};
  std::vector<Vec2> p_moved(taught_.side_lengths_m().size(), Vec2::Zero());
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    PoseEquations equations(fit.T_map_vehicle, p_moved.size());
    equations.add_prior(T_map_expected, sigma_m, sigma_rad);
    std::size_t fitting = 0;
    for (const SeenEdge& one : seen) {
      const Vec2& p = one.p_vehicle;
      const Vec2 p_map = fit.T_map_vehicle * p;
      const TaughtEdges::Edge* edge = taught_.nearest(p_map);
      if (edge == nullptr) continue;
      const Vec2& moved = p_moved[static_cast<std::size_t>(edge->side)];
      const Vec2 off = p_map - edge->p_map - moved;
      const double expected_m2 = variance_m2(one);
      const bool is_on_line = !edge->normal.isZero();
      const double off2_m2 = is_on_line ? square(edge->normal.dot(off)) : off.squaredNorm();
      const bool is_about_there = moved.norm() < kFitting * params_.moved_m;
      fitting += is_about_there && off2_m2 < square(kFitting) * expected_m2 ? 1U : 0U;
      const double weight = 1 / (kAlikePoints * (expected_m2 + off2_m2));
      if (is_on_line) {
        equations.add_point(edge->side, p, edge->normal, edge->normal.dot(off), weight);
      } else {
        equations.add_point(edge->side, p, {1, 0}, off.x(), weight);
        equations.add_point(edge->side, p, {0, 1}, off.y(), weight);
      }
    }
    fit.T_map_vehicle = equations.moved(params_.moved_m, taught_.side_lengths_m(), p_moved);
    fit.fitting_share = static_cast<double>(fitting) / static_cast<double>(seen.size());
  }
  return fit;
}

}  // namespace aisle
