#include "aisle/control/path_fit.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "aisle/core/random.hpp"
#include "closed_loop.hpp"

namespace aisle {
namespace {

/// base_link along a path with lateral wander as of driving by hand, as its odometry gives it.
std::vector<Pose2> driven_by_hand(const Path& path, double wander_m, Random& random) {
  constexpr double kStep_m = 0.03, kComesAndGoes_m = 1;
  std::vector<Pose2> driven;
  double pull = 0, lateral = 0, lateral_before_m = 0;
  for (double along_m = 0; along_m < path.length_m(); along_m += kStep_m) {
    const double fade = kStep_m / kComesAndGoes_m;
    pull += -fade * pull + random.normal(std::sqrt(2 * fade));
    lateral += 3 * fade * (pull - lateral);
    const double lateral_m = wander_m * std::clamp(lateral, -2.0, 2.0);
    const double direction = path.pieces()[path.at(along_m).piece].arc.length_m < 0 ? -1 : 1;
    const double drift_rad =
        direction * std::atan((lateral_m - std::exchange(lateral_before_m, lateral_m)) / kStep_m);
    driven.push_back(path.at(along_m).T_map_path * Pose2{0, lateral_m, drift_rad});
  }
  return driven;
}

/// Straight segments up to 25 m with bends, U-turns and turning points between.
Path any_route(Random& random, double radius_least_m) {
  constexpr double kStraightLeast_m = 2, kStraightMost_m = 25;
  std::vector<Arc> arcs = {{random.uniform(kStraightLeast_m, kStraightMost_m), 0}};
  double direction = 1;
  const std::uint64_t bends = random.index(5);
  for (std::uint64_t i = 0; i < bends; ++i) {
    const double radius_m = random.uniform(radius_least_m, 2),
                 turn_rad = random.uniform() < 0.2 ? kPi : kPi / 2;
    if (random.uniform() < 0.15) direction = -direction;
    arcs.push_back({direction * radius_m * turn_rad, random.uniform() < 0.5 ? turn_rad : -turn_rad});
    arcs.push_back({direction * random.uniform(kStraightLeast_m, kStraightMost_m), 0});
  }
  return path_of(arcs);
}

double stray_m(const Path& path, const std::vector<Pose2>& driven) {
  double along_m = 0, stray_m = 0;
  for (const Pose2& pose : driven) {
    const PathPoint at = path.nearest(pose.position(), along_m - 0.36, along_m + 0.72);
    along_m = std::max(along_m, at.along_m);
    stray_m = std::max(stray_m, (at.T_map_path.position() - pose.position()).norm());
  }
  return stray_m;
}

TEST(FitPath, AStraightCorridorDrivenByHandIsOneLine) {
  Random random(1);
  const Path path = fit_path(driven_by_hand(path_of({{12, 0}}), 0.05, random), {});
  ASSERT_EQ(path.pieces().size(), 1);
  EXPECT_EQ(path.pieces()[0].arc.turn_rad, 0);
}

TEST(FitPath, ABendThatWasDrivenExactlyIsRecovered) {
  Random random(1);
  for (const double radius_m : {0.8, 1.0, 2.0}) {
    const Path true_path = path_of({{4, 0}, {radius_m * kPi / 2, kPi / 2}, {4, 0}});
    const Path path = fit_path(driven_by_hand(true_path, 0, random), {});
    ASSERT_EQ(path.pieces().size(), 3);
    EXPECT_NEAR(1 / path.pieces()[1].curvature_per_m(), radius_m, 0.01);
    EXPECT_NEAR(path.length_m(), true_path.length_m(), 0.04);
  }
}

TEST(FitPath, KeepsCloserToABendThanToTheStraightsBesideIt) {
  constexpr double kBegin_m = 8, kBend_m = 1.1 * kPi / 2;
  double bend_m = 0, straight_m = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Random random(seed);
    const Path true_path = path_of({{kBegin_m, 0}, {kBend_m, kPi / 2}, {8, 0}});
    const std::vector<Pose2> driven = driven_by_hand(true_path, 0.04, random);
    const Path path = fit_path(driven, {});
    double along_m = 0;
    for (const Pose2& pose : driven) {
      const PathPoint at = path.nearest(pose.position(), along_m - 0.36, along_m + 0.72);
      along_m = std::max(along_m, at.along_m);
      const bool is_on_bend = along_m > kBegin_m && along_m < kBegin_m + kBend_m;
      double& stray_m = is_on_bend ? bend_m : straight_m;
      stray_m = std::max(stray_m, (at.T_map_path.position() - pose.position()).norm());
    }
  }
  EXPECT_LT(bend_m, 0.055);
  EXPECT_GT(straight_m, 0.07);
}

TEST(FitPath, KeepsCloserToAPathDrivenBackwardsThanToOneDrivenForwards) {
  const auto worst_stray_m = [](double length_m) {
    double worst_m = 0;
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      Random random(seed);
      const std::vector<Pose2> driven = driven_by_hand(path_of({{length_m, 0}}), 0.04, random);
      worst_m = std::max(worst_m, stray_m(fit_path(driven, {}), driven));
    }
    return worst_m;
  };
  EXPECT_LT(worst_stray_m(-12), 0.055);
  EXPECT_GT(worst_stray_m(12), 0.07);
}

TEST(FitPath, KeepsTurnsOnTheSpotAndTurningPoints) {
  Random random(1);
  std::vector<Pose2> driven = driven_by_hand(path_of({{3, 0}}), 0, random);
  for (int i = 0; i <= 30; ++i) driven.push_back({3, 0, i * 3 * kDegree});
  for (int i = 0; i <= 100; ++i) driven.push_back({3, i * 0.03, kPi / 2});
  for (int i = 0; i <= 100; ++i) driven.push_back({3, 3 - i * 0.03, kPi / 2});
  const Path path = fit_path(driven, {});
  ASSERT_EQ(path.pieces().size(), 4) << path.pieces()[0].arc.length_m;
  EXPECT_TRUE(path.pieces()[1].is_on_the_spot());
  EXPECT_NEAR(path.pieces()[1].arc.turn_rad, kPi / 2, 0.01);
  EXPECT_NEAR(path.pieces()[2].arc.length_m, 3, 0.02);
  EXPECT_NEAR(path.pieces()[3].arc.length_m, -3, 0.02);
}

double backwards_m(const Path& path) {
  double sum_m = 0;
  for (const PathPiece& piece : path.pieces()) sum_m += std::max(0.0, -piece.arc.length_m);
  return sum_m;
}

/// What is wrong with the path that is fitted to a random route; empty: nothing.
std::string fault_of_fit(std::uint64_t seed) {
  Random random(seed);
  const PathFitParams params{.radius_min_m = random.uniform(0.2, 0.8)};
  const Path true_path = any_route(random, 0.3);
  const std::vector<Pose2> driven = driven_by_hand(true_path, random.uniform(0, 0.05), random);
  const Path path = fit_path(driven, params);
  const Vec2 p_map_end = path.end().position();
  if (stray_m(path, driven) > params.stray_max_m) return "strays";
  if (path.pieces().size() > 2 * true_path.pieces().size() + 6) return "of too many pieces";
  if (std::abs(path.length_m() - true_path.length_m()) > 0.02 * true_path.length_m())
    return "of another length";
  if (std::abs(backwards_m(path) - backwards_m(true_path)) > 0.02 * true_path.length_m())
    return "driven the wrong way";
  if ((p_map_end - driven.back().position()).norm() > params.stray_max_m) return "ends elsewhere";
  return "";
}

RC_GTEST_PROP(FitPath, APathDrivenByHandIsRecoveredInFewPieces, (std::uint64_t seed)) {
  RC_ASSERT(fault_of_fit(seed) == "");
}

TEST(FitPath, UTurnsAndNarrowBendsDoNotFallToPieces) {
  constexpr std::uint64_t kSeeds[] = {544273016908975561, 7640213, 2697, 12608352162, 1638, 2161, 2490, 2504};
  for (const std::uint64_t seed : kSeeds) {
    EXPECT_EQ(fault_of_fit(seed), "") << seed;
  }
}

/// To the ends of many branches and back, turning around at each.
Path comb(int branches) {
  const double bend_m = 0.4 * kPi / 2;
  std::vector<Arc> arcs = {{4, 0}};
  for (int i = 0; i < branches; ++i) {
    const double side = i % 2 == 0 ? 1 : -1;
    arcs.insert(arcs.end(), {{bend_m, side * kPi / 2},
                             {9, 0},
                             {0.4 * kPi, side * kPi},
                             {9, 0},
                             {bend_m, side * kPi / 2},
                             {4, 0}});
  }
  return path_of(arcs);
}

TEST(FitPath, ALongPathDoesNotFallToPieces) {
  Random random(1);
  const Path true_path = comb(3);
  const std::vector<Pose2> driven = driven_by_hand(true_path, 0.06, random);
  const PathFitParams params{.stray_max_m = 0.08, .radius_min_m = 0.2};
  const Path path = fit_path(driven, params);
  EXPECT_LE(path.pieces().size(), 3 * true_path.pieces().size());
  EXPECT_LE(stray_m(path, driven), params.stray_max_m);
}

TEST(FitPath, NarrowBendsAreSmoothedWhateverTheLeastRadius) {
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    Random random(seed);
    const Path true_path =
        path_of({{14, 0}, {0.4 * kPi / 2, -kPi / 2}, {9, 0}, {0.4 * kPi / 2, kPi / 2}, {9, 0}});
    const std::vector<Pose2> driven = driven_by_hand(true_path, 0.03, random);
    for (const double radius_min_m : {0.1, 0.2, 0.3, 0.6}) {
      for (const double stray_max_m : {0.08, 0.12, 0.2}) {
        const Path path = fit_path(driven, {.stray_max_m = stray_max_m, .radius_min_m = radius_min_m});
        EXPECT_LE(path.pieces().size(), 20) << seed << " " << radius_min_m << " " << stray_max_m;
        EXPECT_NEAR(path.length_m(), true_path.length_m(), 0.8)
            << seed << " " << radius_min_m << " " << stray_max_m;
      }
    }
  }
}

}  // namespace
}  // namespace aisle
