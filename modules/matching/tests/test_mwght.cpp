#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "aisle/matching/mwght.hpp"
#include "corridor_points.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

using Points = std::vector<WeightedPoint>;

/// The template of the paper's Fig. 6: six points of no symmetry.
Points template_points() {
  return {{{1.0, 2.0}}, {{2.5, 2.2}}, {{3.1, 1.0}}, {{2.0, 0.2}}, {{4.2, 2.6}}, {{5.0, 0.4}}};
}

/// `learned` as seen from a pose that `displacement` corrects.
Points seen_as(const Points& learned, const Pose2& displacement) {
  Points seen = learned;
  for (WeightedPoint& point : seen) point.position = displacement.inverse() * point.position;
  return seen;
}

/// H of one cell straight from (5) to (7); the greatest of all cells that are allowed.
std::optional<MwghtPeak> plain_maximum(const MwghtParams& params, const Points& learned, const Points& seen,
                                       int half_x, int half_y, int half_turn, const MwghtCell* apart_from) {
  MwghtPeak best;
  for (int turn = -half_turn; turn <= half_turn; ++turn) {
    for (int y = -half_y; y <= half_y; ++y) {
      for (int x = -half_x; x <= half_x; ++x) {
        if (apart_from) {
          const double away_m = params.cell_m * std::hypot(x - apart_from->x, y - apart_from->y);
          const double turned_rad = params.angle_step_rad * std::abs(turn - apart_from->turn);
          if (away_m <= params.apart_m && turned_rad <= params.apart_rad) continue;
        }
        double value = 0;
        for (const WeightedPoint& q : seen) {
          for (const WeightedPoint& p : learned) {
            const Vec2 d = p.position - rotate(turn * params.angle_step_rad, q.position);
            const double d1_m = params.cell_m * std::hypot(std::floor(d.x() / params.cell_m + 0.5) - x,
                                                           std::floor(d.y() / params.cell_m + 0.5) - y);
            if (d1_m < params.reach_m + 1e-9)
              value += p.weight * q.weight / (1 + d1_m / params.distance_scale_m);
          }
        }
        if (value > best.value * (1 + 1e-12)) best = {{x, y, turn}, value, {}};
      }
    }
  }
  return best.value > 0 ? std::optional(best) : std::nullopt;
}

TEST(Mwght, TurnsTheSeenPointsCounterClockwiseOntoTheLearnedOnes) {
  // Seen straight ahead at (1, 0) and (2, 0), learned a little to the left: the vehicle has turned more to
  // the left than it thought.
  const double turn_rad = 2 * kDegree;
  const Points seen = {{{1, 0}}, {{2, 0}}};
  const Points learned = {{unit(turn_rad)}, {2 * unit(turn_rad)}};
  const auto answer = Mwght({.cell_m = 0.01}).match(learned, seen, {0.1, 0.1, 4 * kDegree});
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->best.cell, (MwghtCell{0, 0, 8}));
  EXPECT_EQ(answer->best.value, 2);
  EXPECT_THAT(answer->best.displacement, PoseNear(Pose2{0, 0, turn_rad}, 1e-6, 1e-6));
}

TEST(Mwght, FindsTheDisplacementOfTheTemplateExactly) {
  const Pose2 truth{0.317, -0.204, 2.37 * kDegree};
  const Points learned = template_points();
  const auto answer = Mwght().match(learned, seen_as(learned, truth), {});
  ASSERT_TRUE(answer);
  EXPECT_THAT(answer->best.displacement, PoseNear(truth, 1e-6, 1e-6));
  ASSERT_TRUE(answer->runner_up);
  EXPECT_LT(answer->runner_up->value, 0.7 * answer->best.value);
}

TEST(Mwght, AVoteCountsLessInTheCellsAroundItsOwn) {
  // One pair, displaced by 9 cells of 0.05 m, of which the window holds 6: three cells from the vote.
  const MwghtParams params{.cell_m = 0.05, .distance_scale_m = 0.15, .reach_m = 0.3};
  const Points learned = {{{1.45, 0}, 2.0}}, seen = {{{1, 0}, 3.0}};
  const auto answer = Mwght(params).match(learned, seen, {0.3, 0.1, 0});
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->best.cell, (MwghtCell{6, 0, 0}));
  EXPECT_DOUBLE_EQ(answer->best.value, 2.0 * 3.0 / (1 + 0.15 / 0.15));
}

TEST(Mwght, HasNoAnswerWhereNothingVotes) {
  Mwght mwght;
  EXPECT_FALSE(mwght.match({}, {}, {}));
  EXPECT_FALSE(mwght.match(template_points(), {}, {}));
  EXPECT_FALSE(mwght.match({}, template_points(), {}));
  const Points here = {{{0, 0}}}, far = {{{50, 0}}};
  EXPECT_FALSE(mwght.match(here, far, {}));
  EXPECT_THROW(mwght.match(here, far, {-1, 0.5, 0}), std::invalid_argument);
  EXPECT_THROW(mwght.match(here, far, {1e9, 0.5, 0}), std::invalid_argument);
}

TEST(Mwght, OfEqualCellsTheFirstWins) {
  const Points learned = {{{1, 0.2}}, {{1, -0.2}}, {{1.2, 0}}}, seen = {{{1, 0}}};
  const MwghtParams params{.reach_m = 0.05, .apart_m = 0.1};
  Mwght mwght(params);
  for (const auto& answer : {mwght.match(learned, seen, {}), mwght.match_exhaustively(learned, seen, {})}) {
    ASSERT_TRUE(answer && answer->runner_up);
    EXPECT_EQ(answer->best.value, 1);
    EXPECT_EQ(answer->best.cell.turn, -12);
    EXPECT_LT(answer->best.cell.y, 0);
    EXPECT_EQ(answer->runner_up->value, 1);
    EXPECT_EQ(answer->runner_up->cell.turn, -12);
  }
}

TEST(Mwght, OnePointLeavesTheTurnAsUncertainAsTheWindow) {
  const Points learned = {{{3.1, 1.0}}}, seen = {{{3, 1}}};
  const MwghtWindow window{0.5, 0.5, 3 * kDegree};
  const auto answer = Mwght().match(learned, seen, window);
  ASSERT_TRUE(answer);
  EXPECT_TRUE(answer->covariance.allFinite());
  EXPECT_GT(std::sqrt(answer->covariance(2, 2)), 0.5 * window.turn_half_rad);
  EXPECT_LT(std::sqrt(answer->covariance(2, 2)), 2 * window.turn_half_rad);
  const Vec2 placed = answer->best.displacement * seen[0].position;
  EXPECT_THAT(placed, PointNear(learned[0].position, 1e-3));
}

TEST(Mwght, PointsOnOneLineStillTellTheTurn) {
  const Pose2 truth{0.05, 0.02, 1 * kDegree};
  const Points learned = {{{1, 1}}, {{2.2, 1}}, {{4, 1}}, {{7, 1}}};
  const auto answer = Mwght().match(learned, seen_as(learned, truth), {});
  ASSERT_TRUE(answer);
  EXPECT_THAT(answer->best.displacement, PoseNear(truth, 1e-5, 1e-5));
  EXPECT_LT(std::sqrt(answer->covariance(2, 2)), 1 * kDegree);
}

TEST(Mwght, TheCovarianceIsThatOfTheErrors) {
  Random random(3);
  const CorridorSight sight{.learned = 45, .seen = 15, .off = {0.15, 0.08, 1 * kDegree}};
  Mwght mwght;
  Vec3 squared_sigmas = Vec3::Zero();
  int within_5_cm = 0;
  for (int i = 0; i < 200; ++i) {
    const CorridorPoints points = corridor_points(sight, random);
    const auto answer = mwght.match(points.learned, points.seen, {0.25, 0.25, 2 * kDegree});
    ASSERT_TRUE(answer);
    const Pose2 &found = answer->best.displacement, &truth = points.truth;
    const Vec3 error(found.x - truth.x, found.y - truth.y, found.theta - truth.theta);
    within_5_cm += error.head<2>().norm() < 0.05 ? 1 : 0;
    squared_sigmas += error.cwiseAbs2().cwiseQuotient(answer->covariance.diagonal());
  }
  EXPECT_GE(within_5_cm, 160);
  for (const Eigen::Index i : {0, 1, 2}) {
    EXPECT_GT(std::sqrt(squared_sigmas[i] / 200), 0.4) << "sigmas, coordinate " << i;
    EXPECT_LT(std::sqrt(squared_sigmas[i] / 200), 2.5) << "sigmas, coordinate " << i;
  }
}

/// Random patterns: no, few or many points, some on top of each other, weights of many magnitudes.
Points any_points(Random& random) {
  Points points(random.index(4) == 0 ? random.index(3) : random.index(16));
  const double spread_m = random.uniform(0.2, 4), magnitude = random.index(3) == 0 ? 8 : 0.5;
  for (WeightedPoint& point : points) {
    point.position = {random.uniform(-spread_m, spread_m), random.uniform(-spread_m, spread_m) / 3};
    point.weight = std::pow(10, random.uniform(-magnitude, magnitude));
    if (random.index(5) == 0) point.position = points.front().position;
    if (random.index(5) == 0) point.position = (point.position * 5).array().round() / 5;
    if (random.index(3) == 0) point.weight = 1;
  }
  return points;
}

MwghtParams any_params(Random& random) {
  return {.cell_m = random.uniform(0.03, 0.1),
          .angle_step_rad = random.uniform(0.5, 2) * kDegree,
          .distance_scale_m = random.uniform(0.05, 0.3),
          .reach_m = random.index(6) == 0 ? 0 : random.uniform(0.03, 0.6),
          .apart_m = random.uniform(0, 0.6),
          .apart_rad = random.uniform(0, 4) * kDegree};
}

RC_GTEST_PROP(Mwght, BranchAndBoundAnswersAsVotingDoesBitForBit, (std::uint64_t seed)) {
  Random random(seed);
  Mwght mwght(any_params(random));
  for (int again = 0; again < 3; ++again) {
    const Points learned = any_points(random), seen = any_points(random);
    const MwghtWindow window{random.index(5) == 0 ? 0 : random.uniform(0, 2.5),
                             random.index(5) == 0 ? 0 : random.uniform(0, 1.5),
                             random.index(5) == 0 ? 0 : random.uniform(0, 12) * kDegree};
    const auto fast = mwght.match(learned, seen, window),
               slow = mwght.match_exhaustively(learned, seen, window);
    RC_ASSERT(fast.has_value() == slow.has_value());
    if (!fast) continue;
    RC_ASSERT(fast->best.cell == slow->best.cell);
    RC_ASSERT(fast->best.value == slow->best.value);
    RC_ASSERT(fast->runner_up.has_value() == slow->runner_up.has_value());
    RC_ASSERT(fast->covariance.allFinite() && fast->best.displacement.is_finite());
    RC_ASSERT(fast->covariance.diagonal().minCoeff() > 0);
    if (!fast->runner_up) continue;
    RC_ASSERT(fast->runner_up->cell == slow->runner_up->cell);
    RC_ASSERT(fast->runner_up->value == slow->runner_up->value);
  }
}

RC_GTEST_PROP(Mwght, VotingIsTheSumOfThePaper, (std::uint64_t seed)) {
  Random random(seed);
  MwghtParams params = any_params(random);
  params.cell_m = 0.1;
  params.angle_step_rad = 2 * kDegree;
  const Points learned = any_points(random), seen = any_points(random);
  const auto answer = Mwght(params).match_exhaustively(learned, seen, {0.5, 0.3, 4 * kDegree});
  const auto best = plain_maximum(params, learned, seen, 5, 3, 2, nullptr);
  RC_ASSERT(answer.has_value() == best.has_value());
  if (!answer) return;
  RC_ASSERT(std::abs(answer->best.value - best->value) <= 1e-9 * best->value);
  const auto second = plain_maximum(params, learned, seen, 5, 3, 2, &answer->best.cell);
  RC_ASSERT(answer->runner_up.has_value() == second.has_value());
  if (second) RC_ASSERT(std::abs(answer->runner_up->value - second->value) <= 1e-9 * second->value);
}

}  // namespace
}  // namespace aisle
