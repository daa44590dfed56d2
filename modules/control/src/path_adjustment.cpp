#include "path_adjustment.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <utility>

#include "aisle/core/angle.hpp"
#include "loose_piece_slopes.hpp"

namespace aisle {
namespace {

using Kind = LoosePiece::Kind;

constexpr double kShortest_m = 1e-3;
constexpr int kUnknowns = kPieceUnknowns;
constexpr int kOfNext = kUnknowns;

/// How a residual changes with the unknowns of a piece and, from `kOfNext` on, with those of the next.
using Slopes = Eigen::Matrix<double, 2 * kUnknowns, 1>;

/// Residuals of a least-squares problem, gathered piece by piece into its normal equations.
class NormalEquations {
 public:
  explicit NormalEquations(std::size_t pieces)
      : blocks_(pieces, Block::Zero()), gradient_(Eigen::VectorXd::Zero(first_unknown(pieces + 1))) {}

  void add(std::size_t piece, double residual, const Slopes& slopes, double weight) {
    cost_ += weight * residual * residual;
    blocks_[piece] += weight * slopes * slopes.transpose();
    gradient_.segment<2 * kUnknowns>(first_unknown(piece)) -= weight * residual * slopes;
  }

  double cost() const { return cost_; }

  /// The step of all unknowns.
  Eigen::VectorXd solve(double damping) const {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(static_cast<std::size_t>(gradient_.size()) + blocks_.size() * Block::SizeAtCompileTime);
    for (int i = 0; i < gradient_.size(); ++i) entries.emplace_back(i, i, damping);
    for (std::size_t k = 0; k < blocks_.size(); ++k) {
      for (int row = 0; row < 2 * kUnknowns; ++row) {
        for (int column = 0; column < 2 * kUnknowns; ++column) {
          entries.emplace_back(first_unknown(k) + row, first_unknown(k) + column, blocks_[k](row, column));
        }
      }
    }
    Eigen::SparseMatrix<double> matrix(gradient_.size(), gradient_.size());
    matrix.setFromTriplets(entries.begin(), entries.end());
    return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(gradient_);
  }

  static int first_unknown(std::size_t piece) { return static_cast<int>(piece) * kUnknowns; }

 private:
  using Block = Eigen::Matrix<double, 2 * kUnknowns, 2 * kUnknowns>;

  std::vector<Block> blocks_;
  Eigen::VectorXd gradient_;
  double cost_ = 0;
};

/// The end of a piece is the start of the next.
void add_joint(NormalEquations& equations, const LoosePath& loose, std::size_t k, double weight) {
  const Pose2 end = loose.pieces[k].end();
  const Pose2& next = k + 1 < loose.pieces.size() ? loose.pieces[k + 1].T_map_start : loose.T_map_end;
  const Vec3 off{end.x - next.x, end.y - next.y, end.theta - next.theta};
  Eigen::Matrix<double, 3, 2 * kUnknowns> slopes = Eigen::Matrix<double, 3, 2 * kUnknowns>::Zero();
  slopes.leftCols<kUnknowns>() = place_slopes(loose.pieces[k], 1);
  slopes.middleCols<3>(kOfNext) = -Mat3::Identity();
  for (int row = 0; row < 3; ++row) equations.add(k, off[row], slopes.row(row).transpose(), weight);
}

/// The nearest point of its piece is where base_link was. Only a piece's ends pull along it.
void add_driven_point(NormalEquations& equations, const LoosePath& loose, const DrivenPoint& driven_point) {
  const LoosePiece& piece = loose.pieces[driven_point.piece];
  const PathPiece shape{piece.T_map_start, piece.arc()};
  const double along_m = shape.nearest(driven_point.p_map, 0, shape.path_m());
  const Pose2 T_map_nearest = shape.at(along_m);
  const Vec2 off = T_map_nearest.position() - driven_point.p_map;
  const Eigen::Matrix<double, 3, kUnknowns> nearest_slopes = place_slopes(piece, along_m / shape.path_m());
  const auto pull = [&](const Vec2& towards) {
    Slopes slopes = Slopes::Zero();
    slopes.head<kUnknowns>() = nearest_slopes.topRows<2>().transpose() * towards;
    equations.add(driven_point.piece, towards.dot(off), slopes, driven_point.weight);
  };
  const Vec2 ahead = unit(T_map_nearest.theta);
  pull(left_normal(ahead));
  if (along_m == 0 || along_m == shape.path_m()) pull(ahead);
}

/// A leg begins and ends where it was driven to.
void add_leg_end(NormalEquations& equations, const LoosePath& loose, const DrivenPoint& driven_point) {
  const std::size_t k = driven_point.begins_leg ? driven_point.piece : driven_point.piece + 1;
  const Pose2& at = k < loose.pieces.size() ? loose.pieces[k].T_map_start : loose.T_map_end;
  const Vec2 ahead = unit(at.theta);
  Slopes slopes = Slopes::Zero();
  slopes.segment<2>(driven_point.begins_leg ? 0 : kOfNext) = ahead;
  equations.add(driven_point.piece, ahead.dot(at.position() - driven_point.p_map), slopes, 1);
}

void add_bend_limit(NormalEquations& equations, const LoosePath& loose, std::size_t k, double radius_min_m) {
  const LoosePiece& piece = loose.pieces[k];
  const double too_short_m = radius_min_m * std::abs(piece.turn_rad) - piece.length_m;
  if (piece.kind != Kind::kArc || too_short_m < 0) return;
  Slopes slopes = Slopes::Zero();
  slopes[3] = -1;
  slopes[4] = std::copysign(radius_min_m, piece.turn_rad);
  equations.add(k, too_short_m, slopes, 1);
}

/// Without this, two lines with a U-turn between could as well join far beyond it.
void add_driven_length(NormalEquations& equations, const LoosePath& loose, std::size_t k) {
  constexpr double kWeight = 1e-3;
  const LoosePiece& piece = loose.pieces[k];
  if (piece.kind == Kind::kTurnOnTheSpot) return;
  Slopes slopes = Slopes::Zero();
  slopes[3] = 1;
  equations.add(k, piece.length_m - piece.driven_m, slopes, kWeight);
}

NormalEquations equations_of(const LoosePath& loose, double radius_min_m, double joint_weight) {
  NormalEquations equations(loose.pieces.size());
  for (std::size_t k = 0; k < loose.pieces.size(); ++k) {
    add_joint(equations, loose, k, joint_weight);
    add_bend_limit(equations, loose, k, radius_min_m);
    add_driven_length(equations, loose, k);
  }
  for (const DrivenPoint& driven_point : loose.driven_points) {
    add_driven_point(equations, loose, driven_point);
    if (driven_point.begins_leg || driven_point.ends_leg) add_leg_end(equations, loose, driven_point);
  }
  return equations;
}

void move(Pose2& pose, const Vec3& step) {
  pose = {pose.x + step.x(), pose.y + step.y(), pose.theta + step.z()};
}

void apply(LoosePath& loose, const Eigen::VectorXd& step) {
  for (std::size_t k = 0; k < loose.pieces.size(); ++k) {
    LoosePiece& piece = loose.pieces[k];
    const Eigen::Matrix<double, kUnknowns, 1> own =
        step.segment<kUnknowns>(NormalEquations::first_unknown(k));
    move(piece.T_map_start, own.head<3>());
    if (piece.kind != Kind::kTurnOnTheSpot) piece.length_m = std::max(kShortest_m, piece.length_m + own[3]);
    piece.turn_rad += own[4];
  }
  move(loose.T_map_end, step.segment<3>(NormalEquations::first_unknown(loose.pieces.size())));
}

/// Where one piece's driven points end and the next one's begin, each goes to the nearer piece. They stay in
/// order, so that none jumps to another part of the path that passes near by.
void reassign(LoosePath& loose) {
  const auto choose = [&](DrivenPoint& driven_point, std::size_t first, std::size_t last) {
    if (driven_point.begins_leg || driven_point.ends_leg || first == last) return;
    const auto off_m = [&](std::size_t k) {
      const PathPiece shape{loose.pieces[k].T_map_start, loose.pieces[k].arc()};
      return (shape.at(shape.nearest(driven_point.p_map, 0, shape.path_m())).position() - driven_point.p_map)
          .norm();
    };
    double least_m = off_m(driven_point.piece);
    for (std::size_t k = first; k <= last; ++k) {
      const double here_m = off_m(k);
      if (here_m >= least_m) continue;
      driven_point.piece = k;
      least_m = here_m;
    }
  };
  std::vector<DrivenPoint>& driven_points = loose.driven_points;
  for (std::size_t i = 1; i < driven_points.size(); ++i) {
    choose(driven_points[i], driven_points[i - 1].piece, driven_points[i].piece);
  }
  for (std::size_t i = driven_points.size() - 1; i > 0; --i) {
    choose(driven_points[i - 1], driven_points[i - 1].piece, driven_points[i].piece);
  }
}

/// Leaves out the pieces that shrank to nothing; their driven points go to a piece of their leg beside them.
void drop_vanished(LoosePath& loose) {
  const auto is_of_leg = [&](std::size_t k, Gear gear) {
    return k < loose.pieces.size() && loose.pieces[k].kind != Kind::kTurnOnTheSpot &&
           loose.pieces[k].gear == gear;
  };
  for (std::size_t k = loose.pieces.size(); k-- > 0;) {
    const LoosePiece piece = loose.pieces[k];
    if (piece.kind == Kind::kTurnOnTheSpot || piece.length_m > kShortest_m) continue;
    const bool has_before = is_of_leg(k - 1, piece.gear);
    if (!has_before && !is_of_leg(k + 1, piece.gear)) continue;
    loose.pieces.erase(loose.pieces.begin() + static_cast<std::ptrdiff_t>(k));
    for (DrivenPoint& driven_point : loose.driven_points) {
      if (driven_point.piece > k || (driven_point.piece == k && has_before)) --driven_point.piece;
    }
  }
}

/// A step that turns a piece this far may flip it end to end, which the driven points cannot tell apart.
bool whirls(const Eigen::VectorXd& step) {
  constexpr double kTurnMost_rad = 30 * kDegree;
  for (Eigen::Index i = 2; i < step.size(); i += kUnknowns) {
    if (std::abs(step[i]) > kTurnMost_rad) return true;
  }
  return false;
}

/// Levenberg-Marquardt: steps that lower the sum of squares, shorter ones after a step that did not.
void descend(LoosePath& loose, double radius_min_m, double joint_weight) {
  constexpr int kRounds = 30;
  constexpr double kDampingStart = 1e-3, kDampingLeast = 1e-7, kDampingMost = 1e4, kDamp = 10;
  constexpr double kStill = 1e-3;  // of the sum
  NormalEquations here = equations_of(loose, radius_min_m, joint_weight);
  double damping = kDampingStart;
  for (int round = 0; round < kRounds && damping < kDampingMost; ++round) {
    const Eigen::VectorXd step = here.solve(damping);
    LoosePath tried = loose;
    apply(tried, step);
    reassign(tried);
    NormalEquations there = equations_of(tried, radius_min_m, joint_weight);
    if (whirls(step) || !(there.cost() < here.cost())) {
      damping *= kDamp;
      continue;
    }
    const bool is_still = there.cost() > (1 - kStill) * here.cost();
    loose = std::move(tried);
    here = std::move(there);
    damping = std::max(kDampingLeast, damping / kDamp);
    if (is_still) break;
  }
}

}  // namespace

Arc LoosePiece::arc() const {
  return {kind == Kind::kTurnOnTheSpot ? 0 : sign(gear) * length_m, turn_rad};
}

Pose2 LoosePiece::end() const {
  const Vec2 p_map_end = T_map_start * end_pose(arc()).position();
  return {p_map_end.x(), p_map_end.y(), T_map_start.theta + turn_rad};
}

void adjust(LoosePath& loose, double radius_min_m) {
  // first the pieces fit, then they join: stiff joints between pieces far apart lead to a wrong minimum
  for (const double joint_weight : {1.0, 1e2, 1e4, 1e6}) {
    drop_vanished(loose);
    descend(loose, radius_min_m, joint_weight);
  }
}

Path joined(const LoosePath& loose) {
  std::vector<PathPiece> pieces;
  Pose2 T_map_start = loose.pieces.front().T_map_start * Pose2{};
  for (const LoosePiece& piece : loose.pieces) {
    pieces.push_back({T_map_start, piece.arc()});
    T_map_start = pieces.back().end();
  }
  return Path(std::move(pieces));
}

}  // namespace aisle
