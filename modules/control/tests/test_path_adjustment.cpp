#include "path_adjustment.hpp"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "aisle/core/angle.hpp"
#include "aisle/core/random.hpp"
#include "closed_loop.hpp"
#include "loose_piece_slopes.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

using Kind = LoosePiece::Kind;

LoosePiece loose_piece(Kind kind, Gear gear, double length_m, double turn_rad) {
  return {.kind = kind, .gear = gear, .length_m = length_m, .turn_rad = turn_rad, .driven_m = length_m};
}

LoosePiece loose_line(double length_m, Gear gear = Gear::kForward) {
  return loose_piece(Kind::kLine, gear, length_m, 0);
}

LoosePiece loose_bend(double radius_m, double turn_rad, Gear gear = Gear::kForward) {
  return loose_piece(Kind::kArc, gear, radius_m * std::abs(turn_rad), turn_rad);
}

LoosePiece loose_turn(double turn_rad) {
  return loose_piece(Kind::kTurnOnTheSpot, Gear::kForward, 0, turn_rad);
}

/// Pieces that join, and driven points every 5 cm exactly on them.
LoosePath exact_path(std::vector<LoosePiece> pieces, const Pose2& T_map_start = {}) {
  constexpr double kStep_m = 0.05;
  LoosePath loose{.pieces = std::move(pieces), .T_map_end = T_map_start};
  for (std::size_t k = 0; k < loose.pieces.size(); ++k) {
    LoosePiece& piece = loose.pieces[k];
    piece.T_map_start = loose.T_map_end;
    loose.T_map_end = piece.end();
    if (piece.kind == Kind::kTurnOnTheSpot) continue;
    const auto begins_leg = [&](std::size_t at) {
      return at == 0 || loose.pieces[at].kind == Kind::kTurnOnTheSpot ||
             loose.pieces[at - 1].kind == Kind::kTurnOnTheSpot ||
             loose.pieces[at].gear != loose.pieces[at - 1].gear;
    };
    const PathPiece shape{piece.T_map_start, piece.arc()};
    const int steps = static_cast<int>(std::ceil(piece.length_m / kStep_m));
    for (int i = 0; i <= steps; ++i) {
      const bool is_begin = i == 0 && begins_leg(k);
      const bool is_end = i == steps && (k + 1 == loose.pieces.size() || begins_leg(k + 1));
      if (i == 0 && !is_begin) continue;
      loose.driven_points.push_back({.p_map = shape.at(piece.length_m * i / steps).position(),
                                     .piece = k,
                                     .begins_leg = is_begin,
                                     .ends_leg = is_end});
    }
  }
  return loose;
}

/// Forwards, around bends, backwards, and after a turn on the spot forwards again.
LoosePath varied_path(const Pose2& T_map_start = {}) {
  return exact_path(
      {loose_line(3), loose_bend(0.8, kPi / 2), loose_line(2), loose_bend(1.2, -kPi / 3, Gear::kReverse),
       loose_line(1.5, Gear::kReverse), loose_turn(kPi / 2), loose_line(2.5)},
      T_map_start);
}

/// The pieces start elsewhere, and are longer and more bent than they were driven.
void disturb(LoosePath& loose, Random& random) {
  for (LoosePiece& piece : loose.pieces) {
    Pose2& T = piece.T_map_start;
    T = {T.x + random.uniform(-0.04, 0.04), T.y + random.uniform(-0.04, 0.04),
         T.theta + random.uniform(-3, 3) * kDegree};
    piece.length_m *= random.uniform(0.95, 1.05);
    piece.turn_rad *= random.uniform(0.95, 1.05);
  }
}

double gap_most_m(const LoosePath& loose) {
  double most_m = 0;
  for (std::size_t k = 0; k < loose.pieces.size(); ++k) {
    const Pose2& next = k + 1 < loose.pieces.size() ? loose.pieces[k + 1].T_map_start : loose.T_map_end;
    most_m = std::max(most_m, (loose.pieces[k].end().position() - next.position()).norm());
  }
  return most_m;
}

double apart_m(const LoosePath& a, const LoosePath& b) {
  double most_m = (a.T_map_end.position() - b.T_map_end.position()).norm();
  for (std::size_t k = 0; k < a.pieces.size(); ++k)
    most_m =
        std::max(most_m, (a.pieces[k].T_map_start.position() - b.pieces[k].T_map_start.position()).norm());
  return most_m;
}

RC_GTEST_PROP(PathAdjustment, SlopesOfAPlaceAreItsNumericalDerivatives, (std::uint64_t seed)) {
  constexpr double kNudge = 1e-6;
  Random random(seed);
  const Gear gear = random.uniform() < 0.5 ? Gear::kForward : Gear::kReverse;
  const double turn_rad = random.uniform(-3, 3);
  const double share = random.uniform();
  for (LoosePiece piece : {loose_line(random.uniform(0.1, 5), gear),
                           loose_piece(Kind::kArc, gear, random.uniform(0.1, 5), turn_rad),
                           loose_piece(Kind::kArc, gear, 1, 0), loose_turn(turn_rad)}) {
    piece.T_map_start = {random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-4, 4)};
    const auto place = [&](int unknown, double by) {
      LoosePiece moved = piece;
      double* const unknowns[] = {&moved.T_map_start.x, &moved.T_map_start.y, &moved.T_map_start.theta,
                                  &moved.length_m, &moved.turn_rad};
      // a line stays straight, a turn stays on the spot
      const bool is_fixed =
          (unknown == 4 && piece.kind == Kind::kLine) || (unknown == 3 && piece.kind == Kind::kTurnOnTheSpot);
      if (!is_fixed) *unknowns[unknown] += by;
      const Arc arc = moved.arc();
      const Vec2 p_map =
          moved.T_map_start * end_pose({share * arc.length_m, share * arc.turn_rad}).position();
      return Vec3(p_map.x(), p_map.y(), moved.T_map_start.theta + share * arc.turn_rad);
    };
    const auto slopes = place_slopes(piece, share);
    for (int i = 0; i < kPieceUnknowns; ++i) {
      const Vec3 numerical = (place(i, kNudge) - place(i, -kNudge)) / (2 * kNudge);
      RC_ASSERT((slopes.col(i) - numerical).norm() < 1e-7);
    }
  }
}

TEST(PathAdjustment, APathThatJoinsWhereItWasDrivenStaysAsItIs) {
  const LoosePath before = varied_path({2, -1, 0.7});
  LoosePath loose = before;
  adjust(loose, 0.3);
  ASSERT_EQ(loose.pieces.size(), before.pieces.size());
  EXPECT_LT(apart_m(loose, before), 1e-9);
  for (std::size_t k = 0; k < before.pieces.size(); ++k) {
    EXPECT_NEAR(loose.pieces[k].T_map_start.theta, before.pieces[k].T_map_start.theta, 1e-9);
    EXPECT_NEAR(loose.pieces[k].length_m, before.pieces[k].length_m, 1e-9);
    EXPECT_NEAR(loose.pieces[k].turn_rad, before.pieces[k].turn_rad, 1e-9);
  }
}

RC_GTEST_PROP(PathAdjustment, PiecesThatDoNotJoinGoBackToThePathThatWasDriven, (std::uint64_t seed)) {
  Random random(seed);
  const LoosePath driven = varied_path();
  LoosePath loose = driven;
  disturb(loose, random);
  RC_ASSERT(gap_most_m(loose) > 0.02);
  adjust(loose, 0.3);
  RC_ASSERT(loose.pieces.size() == driven.pieces.size());
  RC_ASSERT(gap_most_m(loose) < 1e-4);
  RC_ASSERT(apart_m(loose, driven) < 0.005);
  RC_ASSERT((joined(loose).end().position() - driven.T_map_end.position()).norm() < 0.005);
}

RC_GTEST_PROP(PathAdjustment, CornersStayWhereTheDriveTurnedOnTheSpot, (std::uint64_t seed)) {
  Random random(seed);
  const double turn_rad = random.uniform(30, 150) * kDegree;
  const LoosePath driven = exact_path({loose_line(3), loose_turn(turn_rad), loose_line(2)});
  LoosePath loose = driven;
  for (DrivenPoint& point : loose.driven_points)
    point.p_map += Vec2(random.normal(0.01), random.normal(0.01));
  disturb(loose, random);
  adjust(loose, 0.6);
  RC_ASSERT(loose.pieces.size() == 3U);
  RC_ASSERT(loose.pieces[1].kind == Kind::kTurnOnTheSpot);
  RC_ASSERT(loose.pieces[0].turn_rad == 0);
  RC_ASSERT(loose.pieces[1].arc().length_m == 0);
  RC_ASSERT((loose.pieces[1].T_map_start.position() - Vec2(3, 0)).norm() < 0.04);
  RC_ASSERT(std::abs(loose.pieces[1].turn_rad - turn_rad) < 3 * kDegree);
}

/// Turns and moves everything.
LoosePath moved_by(const Pose2& T, LoosePath loose) {
  const auto move = [&](Pose2& pose) {
    const Vec2 p = T * pose.position();
    pose = {p.x(), p.y(), T.theta + pose.theta};
  };
  for (LoosePiece& piece : loose.pieces) move(piece.T_map_start);
  for (DrivenPoint& point : loose.driven_points) point.p_map = T * point.p_map;
  move(loose.T_map_end);
  return loose;
}

RC_GTEST_PROP(PathAdjustment, ACommonMotionOfTheFrameChangesNothing, (std::uint64_t seed)) {
  Random random(seed);
  LoosePath here = varied_path();
  disturb(here, random);
  const Pose2 T{random.uniform(-20, 20), random.uniform(-20, 20), random.uniform(-3, 3)};
  LoosePath elsewhere = moved_by(T, here);
  adjust(here, 0.3);
  adjust(elsewhere, 0.3);
  RC_ASSERT(here.pieces.size() == elsewhere.pieces.size());
  RC_ASSERT(apart_m(moved_by(T, here), elsewhere) < 1e-9);
}

RC_GTEST_PROP(PathAdjustment, ALineIsTheLineOfLeastSquares, (std::uint64_t seed)) {
  Random random(seed);
  LoosePath loose = exact_path({loose_line(4)}, {1, 2, 0.5});
  Vec2 mean = Vec2::Zero();
  for (DrivenPoint& point : loose.driven_points) {
    if (!point.begins_leg && !point.ends_leg) point.p_map += random.normal(0.03) * left_normal(unit(0.5));
    mean += point.p_map / static_cast<double>(loose.driven_points.size());
  }
  Mat2 scatter = Mat2::Zero();
  for (const DrivenPoint& point : loose.driven_points)
    scatter += (point.p_map - mean) * (point.p_map - mean).transpose();
  const Vec2 along = Eigen::SelfAdjointEigenSolver<Mat2>(scatter).eigenvectors().col(1);
  disturb(loose, random);
  adjust(loose, 0.6);
  for (const Vec2& p : {loose.pieces[0].T_map_start.position(), loose.pieces[0].end().position()})
    RC_ASSERT(std::abs(cross(along, p - mean)) < 2e-4);
}

TEST(PathAdjustment, ABendTighterThanAllowedOpensTowardsTheLeastRadius) {
  const auto radius_m = [](double radius_min_m) {
    LoosePath loose = exact_path({loose_line(2), loose_bend(0.4, kPi / 2), loose_line(2)});
    adjust(loose, radius_min_m);
    EXPECT_LT(gap_most_m(loose), 1e-3);
    return loose.pieces[1].length_m / loose.pieces[1].turn_rad;
  };
  EXPECT_NEAR(radius_m(0.3), 0.4, 1e-6);
  EXPECT_NEAR(radius_m(0.4), 0.4, 1e-6);
  EXPECT_GT(radius_m(0.6), 0.5);
  EXPECT_LE(radius_m(0.6), 0.6);
}

TEST(PathAdjustment, APieceThatShrankToNothingIsLeftOutAndItsPointsGoOn) {
  LoosePath loose = exact_path({loose_line(2), loose_bend(0.8, kPi / 4), loose_line(2)});
  LoosePiece nothing = loose_bend(1, 0);
  nothing.T_map_start = loose.pieces[1].T_map_start;
  loose.pieces.insert(loose.pieces.begin() + 1, nothing);
  for (DrivenPoint& point : loose.driven_points)
    if (point.piece > 0) ++point.piece;
  const LoosePath expected = exact_path({loose_line(2), loose_bend(0.8, kPi / 4), loose_line(2)});
  adjust(loose, 0.3);
  ASSERT_EQ(loose.pieces.size(), 3U);
  EXPECT_LT(apart_m(loose, expected), 1e-9);
  EXPECT_EQ(loose.driven_points.back().piece, 2U);
}

}  // namespace
}  // namespace aisle
