#include "path_adjustment.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

using Kind = LoosePiece::Kind;

constexpr int kUnknowns = 5;  ///< of a piece: x, y, theta of its start, length, and curvature or turn
constexpr double kJoins = 1e5;
constexpr double kDamping = 1e-6;

/// Rows of a linear least-squares problem, gathered into its normal equations.
class NormalEquations {
 public:
  explicit NormalEquations(int unknowns) : size_(unknowns), gradient_(Eigen::VectorXd::Zero(unknowns)) {
    for (int i = 0; i < unknowns; ++i) entries_.emplace_back(i, i, kDamping);
  }

  struct Term {
    int unknown;
    double slope;
  };

  /// A residual that changes by `slope` with each unknown.
  void add(double residual, std::initializer_list<Term> terms, double weight) {
    for (const Term& a : terms) {
      gradient_[a.unknown] -= weight * a.slope * residual;
      for (const Term& b : terms) entries_.emplace_back(a.unknown, b.unknown, weight * a.slope * b.slope);
    }
  }

  Eigen::VectorXd solve() const {
    Eigen::SparseMatrix<double> matrix(size_, size_);
    matrix.setFromTriplets(entries_.begin(), entries_.end());
    return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(gradient_);
  }

 private:
  int size_;
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::VectorXd gradient_;
};

int unknown(std::size_t piece, int which) {
  return static_cast<int>(piece) * kUnknowns + which;
}

/// The end of a piece is the start of the next.
void add_joint(NormalEquations& equations, const LoosePath& loose, std::size_t k) {
  const LoosePiece& piece = loose.pieces[k];
  const Pose2& next = k + 1 < loose.pieces.size() ? loose.pieces[k + 1].T_map_start : loose.T_map_end;
  const Arc arc = piece.arc();
  const Pose2 end = piece.T_map_start * end_pose(arc);
  const Mat32 local = end_pose_jacobian(arc);
  const Vec2 lever = end.position() - piece.T_map_start.position();
  // by (length, curvature or turn)
  Mat32 by_arc = local;
  by_arc.topRows<2>() << rotate(piece.T_map_start.theta, local.topRows<2>().col(0)),
      rotate(piece.T_map_start.theta, local.topRows<2>().col(1));
  const bool on_the_spot = piece.kind == Kind::kTurnOnTheSpot;
  Mat32 by_own = by_arc;
  if (!on_the_spot) {
    const double signed_curvature = piece.curvature_per_m * piece.direction;
    by_own.col(0) = piece.direction * by_arc.col(0) + signed_curvature * by_arc.col(1);
    by_own.col(1) = piece.length_m * piece.direction * by_arc.col(1);
  }
  const double off[3] = {end.x - next.x, end.y - next.y, wrap_angle(end.theta - next.theta)};
  const double by_heading[3] = {-lever.y(), lever.x(), 1};
  for (int row = 0; row < 3; ++row) {
    const double by_position = row < 2 ? 1 : 0;
    equations.add(off[row],
                  {{unknown(k, row), row < 2 ? by_position : 0},
                   {unknown(k, 2), by_heading[row]},
                   {unknown(k, 3), on_the_spot ? 0 : by_own(row, 0)},
                   {unknown(k, 4), piece.kind == Kind::kLine ? 0 : by_own(row, 1)},
                   {unknown(k + 1, row), -1}},
                  kJoins);
  }
}

void add_waypoint(NormalEquations& equations, const LoosePath& loose, const Waypoint& waypoint) {
  const std::size_t k = waypoint.piece;
  const LoosePiece& piece = loose.pieces[k];
  const PathPiece shape{piece.T_map_start, piece.arc()};
  const double along_m = shape.nearest(waypoint.p_map, 0, shape.way_m()) * piece.direction;
  const Arc part{along_m, piece.curvature_per_m * along_m};
  const Pose2 T_map_foot = piece.T_map_start * end_pose(part);
  const Vec2 off = T_map_foot.position() - waypoint.p_map;
  const Vec2 lever = T_map_foot.position() - piece.T_map_start.position();
  const Vec2 by_curvature =
      rotate(piece.T_map_start.theta, end_pose_jacobian(part).topRows<2>().col(1)) * along_m;
  const Vec2 left = left_normal(unit(T_map_foot.theta));
  const double free_curvature = piece.kind == Kind::kArc ? 1 : 0;
  equations.add(left.dot(off),
                {{unknown(k, 0), left.x()},
                 {unknown(k, 1), left.y()},
                 {unknown(k, 2), left.dot(left_normal(lever))},
                 {unknown(k, 4), free_curvature * left.dot(by_curvature)}},
                waypoint.weight);
}

/// A leg begins and ends where it was driven to.
void add_leg_end(NormalEquations& equations, const LoosePath& loose, const Waypoint& waypoint) {
  const std::size_t k = waypoint.begins_leg ? waypoint.piece : waypoint.piece + 1;
  const Pose2& at = k < loose.pieces.size() ? loose.pieces[k].T_map_start : loose.T_map_end;
  const Vec2 ahead = unit(at.theta);
  equations.add(ahead.dot(at.position() - waypoint.p_map),
                {{unknown(k, 0), ahead.x()}, {unknown(k, 1), ahead.y()}}, 1);
}

NormalEquations equations_of(const LoosePath& loose, double radius_min_m) {
  NormalEquations equations(static_cast<int>(loose.pieces.size() + 1) * kUnknowns);
  for (std::size_t k = 0; k < loose.pieces.size(); ++k) {
    const LoosePiece& piece = loose.pieces[k];
    add_joint(equations, loose, k);
    if (piece.kind == Kind::kTurnOnTheSpot) continue;
    const double too_bent = std::abs(piece.curvature_per_m) - 1 / radius_min_m;
    if (too_bent > 0) {
      const double side = std::copysign(1, piece.curvature_per_m);
      equations.add(side * too_bent, {{unknown(k, 4), 1}}, 1);
    }
  }
  for (const Waypoint& waypoint : loose.waypoints) {
    add_waypoint(equations, loose, waypoint);
    if (waypoint.begins_leg || waypoint.ends_leg) add_leg_end(equations, loose, waypoint);
  }
  return equations;
}

Pose2 moved(const Pose2& pose, const Eigen::VectorXd& step, std::size_t k) {
  return {pose.x + step[unknown(k, 0)], pose.y + step[unknown(k, 1)],
          wrap_angle(pose.theta + step[unknown(k, 2)])};
}

void apply(LoosePath& loose, const Eigen::VectorXd& step) {
  constexpr double kShortest_m = 1e-3;
  for (std::size_t k = 0; k < loose.pieces.size(); ++k) {
    LoosePiece& piece = loose.pieces[k];
    piece.T_map_start = moved(piece.T_map_start, step, k);
    if (piece.kind == Kind::kTurnOnTheSpot) {
      piece.turn_rad += step[unknown(k, 4)];
      continue;
    }
    piece.length_m = std::max(kShortest_m, piece.length_m + step[unknown(k, 3)]);
    if (piece.kind == Kind::kArc) piece.curvature_per_m += step[unknown(k, 4)];
  }
  loose.T_map_end = moved(loose.T_map_end, step, loose.pieces.size());
}

/// Each waypoint goes to the piece beside its own that is nearest.
void reassign(LoosePath& loose) {
  const auto off_m = [&](std::size_t k, const Vec2& p_map) {
    const PathPiece shape{loose.pieces[k].T_map_start, loose.pieces[k].arc()};
    return (shape.at(shape.nearest(p_map, 0, shape.way_m())).position() - p_map).norm();
  };
  const auto is_of_leg = [&](std::size_t k, std::size_t own) {
    return k < loose.pieces.size() && loose.pieces[k].kind != Kind::kTurnOnTheSpot &&
           loose.pieces[k].direction == loose.pieces[own].direction;
  };
  for (Waypoint& waypoint : loose.waypoints) {
    if (waypoint.begins_leg || waypoint.ends_leg) continue;
    const std::size_t own = waypoint.piece;
    for (const std::size_t k : {own - 1, own + 1}) {
      if (is_of_leg(k, own) && off_m(k, waypoint.p_map) < off_m(waypoint.piece, waypoint.p_map)) {
        waypoint.piece = k;
      }
    }
  }
}

}  // namespace

Arc LoosePiece::arc() const {
  if (kind == Kind::kTurnOnTheSpot) return {0, turn_rad};
  return {direction * length_m, direction * length_m * curvature_per_m};
}

void adjust(LoosePath& loose, double radius_min_m) {
  constexpr int kRounds = 30;
  constexpr double kStepMax = 0.3;  // of metres, radians, and curvatures: farther the slopes do not hold
  constexpr double kStill = 1e-7;
  for (int round = 0; round < kRounds; ++round) {
    const Eigen::VectorXd step = equations_of(loose, radius_min_m).solve();
    const double largest = step.lpNorm<Eigen::Infinity>();
    if (!std::isfinite(largest)) break;
    apply(loose, std::min(1.0, kStepMax / largest) * step);
    if (largest < kStill) break;
    reassign(loose);
  }
}

Path joined(const LoosePath& loose) {
  std::vector<PathPiece> pieces;
  Pose2 T_map_start = loose.pieces.front().T_map_start;
  for (const LoosePiece& piece : loose.pieces) {
    pieces.push_back({T_map_start, piece.arc()});
    T_map_start = pieces.back().end();
  }
  return Path(std::move(pieces));
}

}  // namespace aisle
