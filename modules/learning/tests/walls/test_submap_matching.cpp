#include "walls/submap_matching.hpp"

#include <gmock/gmock.h>

#include <rapidcheck/gtest.h>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "aisle/core/random.hpp"
#include "aisle/core/square.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

using Walls = std::vector<WallEstimate>;

constexpr double kHalfCell_m = 0.02;  // of the signatures, on each of two axes

WallEstimate learned_wall(const Segment2& segment, bool oblique) {
  WallEstimate wall;
  wall.set_heading(segment.heading());
  if (!oblique) wall.facing = facing_of(wall.heading_rad, 1 * kDegree);
  wall.anchor = segment.midpoint();
  wall.extent = {-segment.length() / 2, segment.length() / 2};
  wall.sightings = 5;
  return wall;
}

Walls learned_walls(const std::vector<Segment2>& segments, const Pose2& T_map_place, bool oblique) {
  Walls walls;
  for (const Segment2& segment : segments) walls.push_back(learned_wall(T_map_place * segment, oblique));
  return walls;
}

/// A room of 6 x 5 m without one of its corners, and with a cupboard.
std::vector<Segment2> office() {
  return {{{0, 0}, {6, 0}}, {{6, 0}, {6, 4}}, {{6, 4}, {4, 4}},       {{4, 4}, {4, 5}},
          {{4, 5}, {0, 5}}, {{0, 5}, {0, 0}}, {{1.2, 0.6}, {0, 0.6}}, {{1.2, 0}, {1.2, 0.6}}};
}

/// Two walls 2 m apart, from x = `begin_m` to `end_m`.
std::vector<Segment2> bare_corridor(double begin_m, double end_m) {
  return {{{begin_m, -1}, {end_m, -1}}, {{end_m, 1}, {begin_m, 1}}};
}

/// The same with the far side of a pillar every metre on both sides.
std::vector<Segment2> corridor_of_pillars(int begin_m, int end_m) {
  std::vector<Segment2> segments = bare_corridor(begin_m, end_m);
  for (int x = begin_m; x < end_m; ++x) {
    segments.push_back({{x + 0.5, -0.5}, {x + 0.5, -1}});
    segments.push_back({{x + 0.5, 1}, {x + 0.5, 0.5}});
  }
  return segments;
}

KnownArea known_everywhere() {
  KnownArea known;
  known.include(Vec2::Zero(), 1000);
  return known;
}

/// A submap of these segments, anchored at (3, 2).
Submap submap_of(const std::vector<Segment2>& segments, bool oblique) {
  Submap submap;
  submap.T_track_anchor = {3, 2, 0};
  submap.walls = learned_walls(segments, {}, oblique);
  return submap;
}

SubmapFit fit_onto(const Walls& fresh, const Walls& old, double reach_m) {
  return fit_submap(fresh, WallPattern(old), known_everywhere(), reach_m);
}

Vec2 any_displacement(double reach_m) {
  const auto share = [] { return *rc::gen::inRange(-1000, 1001) / 1000.0; };
  const double x = share(), y = share();
  return reach_m * Vec2(x, y);
}

Pose2 any_turned_pose() {
  const Vec2 position = any_displacement(20);
  return {position.x(), position.y(), *rc::gen::inRange(-3141, 3142) / 1000.0};
}

/// Walls in all directions in a yard of 10 x 10 m, in part on the axes.
Walls any_walls(std::size_t count, Random& random) {
  Walls walls;
  for (std::size_t i = 0; i < count; ++i) {
    const bool oblique = random.uniform() < 0.3;
    const double heading_rad =
        oblique ? random.uniform(-kPi, kPi) : static_cast<double>(random.index(4)) * kPi / 2;
    const Vec2 start{random.uniform(0, 10), random.uniform(0, 10)};
    walls.push_back(learned_wall({start, start + random.uniform(0.2, 5) * unit(heading_rad)}, oblique));
  }
  return walls;
}

RC_GTEST_PROP(WallPattern, FindsEachOfItsWallsAtItsOwnPlaceInFullLength, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const Walls walls = any_walls(60, random);
  const WallPattern pattern(walls);
  for (const WallEstimate& wall : walls) {
    const WallPattern::Hit hit = pattern.hit(wall, Vec2::Zero(), 0.15);
    RC_ASSERT(hit.wall != nullptr);
    RC_ASSERT(std::abs(hit.common_m - wall.length_m()) < 1e-9);
  }
}

RC_GTEST_PROP(WallPattern, FindsWhatTryingEveryWallAloneFinds, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const Walls walls = any_walls(60, random);
  const WallPattern all(walls);
  for (const WallEstimate& wall : any_walls(20, random)) {
    const Vec2 displacement_m{random.uniform(-2, 2), random.uniform(-2, 2)};
    double longest_m = 0;
    for (const WallEstimate& one : walls)
      longest_m = std::max(longest_m, WallPattern({one}).hit(wall, displacement_m, 0.15).common_m);
    RC_ASSERT(all.hit(wall, displacement_m, 0.15).common_m == longest_m);
  }
}

TEST(WallPattern, AWallAcrossCountsByHalfAtTheGateAndNotBeyond) {
  for (const bool oblique : {false, true}) {
    const WallPattern pattern(learned_walls({{{0, 0}, {4, 0}}}, {}, oblique));
    const WallEstimate wall = learned_wall({{1, 0}, {3, 0}}, oblique);
    EXPECT_NEAR(pattern.hit(wall, {0, 0}, 0.2).common_m, 2, 1e-12);
    EXPECT_NEAR(pattern.hit(wall, {0, 0.1}, 0.2).common_m, 2 * 0.75, 1e-12);
    EXPECT_NEAR(pattern.hit(wall, {0, -0.199999}, 0.2).common_m, 2 * 0.5, 1e-5);
    EXPECT_EQ(pattern.hit(wall, {0, 0.21}, 0.2).wall, nullptr);
    EXPECT_NEAR(pattern.hit(wall, {2, 0}, 0.2).common_m, 1, 1e-12) << "half of it is beyond the end";
    EXPECT_EQ(pattern.hit(wall, {4, 0}, 0.2).wall, nullptr);
  }
}

TEST(WallPattern, TheBackOfAWallIsNotTheWall) {
  for (const bool oblique : {false, true}) {
    const WallPattern pattern(learned_walls({{{0, 0}, {4, 0}}}, {}, oblique));
    EXPECT_EQ(pattern.hit(learned_wall({{3, 0}, {1, 0}}, oblique), {0, 0}, 0.2).wall, nullptr);
  }
}

TEST(SubmapFit, IdenticalSubmapsAreNotDisplaced) {
  for (const bool oblique : {false, true}) {
    const Walls walls = learned_walls(office(), {2, -7, oblique ? 0.5 : 0}, oblique);
    const SubmapFit fit = fit_onto(walls, walls, 3);
    EXPECT_EQ(fit.displacement_m, Vec2(0, 0));
    EXPECT_NEAR(fit.score, 1, 1e-12);
    EXPECT_LT(fit.rival_score, 0.7);
  }
}

RC_GTEST_PROP(SubmapFit, FindsAKnownDisplacementAndRefinesItToTheDigit, ()) {
  const bool oblique = *rc::gen::arbitrary<bool>();
  const Pose2 T_map_track{0, 0, oblique ? 0.5 : 0};
  const Vec2 displacement_m = any_displacement(2);
  const Pose2 T_map_place{displacement_m.x(), displacement_m.y(), T_map_track.theta};
  const Submap submap = submap_of(office(), oblique);
  const WallPattern old(learned_walls(office(), T_map_place, oblique));
  const Pose2 expected = T_map_track * submap.T_track_anchor;
  Walls fresh;
  place_walls(submap, expected, fresh);

  const SubmapFit fit = fit_submap(fresh, old, known_everywhere(), 3);
  RC_ASSERT((fit.displacement_m - displacement_m).norm() < 2 * kHalfCell_m);
  RC_ASSERT(fit.rival_score < 0.85 * fit.score);

  const Pose2 found{expected.x + fit.displacement_m.x(), expected.y + fit.displacement_m.y(), expected.theta};
  const RefinedFit refined = refine_fit(submap, found, old, known_everywhere());
  RC_ASSERT(testing::Value(refined.T_map_anchor, PoseNear(T_map_place * submap.T_track_anchor, 1e-7, 1e-7)));
}

/// Fits the office, displaced by 0.59 m and 0.91 m in its own frame, with everything moved by `T_map_place`.
SubmapFit moved_fit(const Pose2& T_map_place, bool oblique) {
  const Walls fresh = learned_walls(office(), T_map_place * Pose2{-0.59, 0.91, 0}, oblique);
  return fit_onto(fresh, learned_walls(office(), T_map_place, oblique), 2);
}

RC_GTEST_PROP(SubmapFit, IsTheSameAfterACommonMotion, ()) {
  const bool oblique = *rc::gen::arbitrary<bool>();
  Pose2 moved = any_turned_pose();
  if (!oblique) moved.theta = *rc::gen::inRange(-2, 2) * kPi / 2;
  const SubmapFit first = moved_fit({}, oblique), second = moved_fit(moved, oblique);
  RC_ASSERT((first.displacement_m - Vec2(0.59, -0.91)).norm() < 2 * kHalfCell_m);
  RC_ASSERT((second.displacement_m - rotate(moved.theta, first.displacement_m)).norm() < 2 * kHalfCell_m);
}

TEST(SubmapFit, FindsADisplacementBetweenWallsThatMeetAtOtherAngles) {
  const Vec2 east(5, 0), north_east = 4 * unit(60 * kDegree);
  const std::vector<Segment2> walls = {{{0, 0}, east},
                                       {east, east + north_east},
                                       {east + north_east, north_east},
                                       {north_east, {0, 0}},
                                       {0.3 * east + 0.4 * north_east, 0.3 * east}};
  for (const double direction_rad : {0.3, 1.4, -2.0}) {
    const Pose2 T_map_place{7, -3, direction_rad};
    const Vec2 truth_m = rotate(direction_rad, {0.7, -1.1});
    const Walls fresh = learned_walls(walls, T_map_place * Pose2{-0.7, 1.1, 0}, true);
    const SubmapFit fit = fit_onto(fresh, learned_walls(walls, T_map_place, true), 2);
    // Half a cell on both axes moves the point where they cross by at most two halves.
    EXPECT_THAT(fit.displacement_m, PointNear(truth_m, 2 * kHalfCell_m)) << direction_rad;
  }
}

TEST(SubmapFit, WhatFixesXFixesYAfterAQuarterTurn) {
  const SubmapFit first = moved_fit({}, false), turned = moved_fit({0, 0, kPi / 2}, false);
  EXPECT_NEAR(turned.matched_m[0], first.matched_m[1], 1e-9);
  EXPECT_NEAR(turned.matched_m[1], first.matched_m[0], 1e-9);
  EXPECT_NEAR(turned.score, first.score, 1e-9);
}

TEST(SubmapFit, ACorridorLeavesOpenWhereOneIsAlongIt) {
  const Walls old = learned_walls(bare_corridor(0, 20), {}, false);
  const SubmapFit fit = fit_onto(learned_walls(bare_corridor(8, 12), {0, 0.31, 0}, false), old, 1);
  EXPECT_NEAR(fit.displacement_m.y(), -0.31, kHalfCell_m);
  EXPECT_NEAR(fit.matched_m[0], 0, 1e-12);
  EXPECT_GT(fit.matched_m[1], 5);
}

TEST(SubmapFit, PlacesThatLookAlikeHaveRivals) {
  const Walls old = learned_walls(corridor_of_pillars(0, 20), {}, false);
  const Walls fresh = learned_walls(corridor_of_pillars(8, 12), {0.2, 0.1, 0}, false);
  const SubmapFit within_half_a_metre = fit_onto(fresh, old, 0.4);
  EXPECT_THAT(within_half_a_metre.displacement_m, PointNear(Vec2(-0.2, -0.1), 2 * kHalfCell_m));
  EXPECT_LT(within_half_a_metre.rival_score, 0.85 * within_half_a_metre.score);
  const SubmapFit wide = fit_onto(fresh, old, 1.5);
  EXPECT_GT(wide.rival_score, 0.95 * wide.score);
}

TEST(SubmapFit, AnotherPlaceDoesNotFit) {
  Random random(3);
  for (int i = 0; i < 20; ++i) {
    Walls elsewhere = any_walls(12, random);
    std::erase_if(elsewhere, [](const WallEstimate& wall) { return wall.is_oblique(); });
    EXPECT_LT(fit_onto(learned_walls(office(), {}, false), elsewhere, 1).score, 0.5) << i;
  }
}

TEST(SubmapFit, WallsThatNobodyCouldKnowDoNotCountAgainstIt) {
  KnownArea known;
  known.include({3, 2.5}, 4);
  std::vector<Segment2> more = office();
  more.push_back({{9, 0}, {9, 5}});
  const WallPattern old(learned_walls(office(), {}, false));
  const Walls fresh = learned_walls(more, {}, false);
  EXPECT_NEAR(fit_submap(fresh, old, known, 1).score, 1, 1e-12);
  EXPECT_LT(fit_submap(fresh, old, known_everywhere(), 1).score, 0.9);
}

TEST(SubmapFit, AShortWallAloneSaysNothing) {
  const Walls two_metres = learned_walls({{{0, 0}, {1.9, 0}}}, {}, false);
  EXPECT_EQ(fit_onto(two_metres, two_metres, 1).score, 0);
  EXPECT_EQ(fit_onto({}, two_metres, 1).score, 0);
  EXPECT_EQ(fit_onto(two_metres, {}, 1).score, 0);
}

TEST(LikelyTurns, AreAboutTheTurnBetweenTheTwo) {
  const Walls fresh = learned_walls(office(), {0, 0, 0.4}, true);
  for (int tenths = -116; tenths < 120; tenths += 3) {
    const double turn_deg = tenths / 10.0;
    const Walls old = learned_walls(office(), {5, 2, 0.4 + turn_deg * kDegree}, true);
    const std::vector<double> turns_rad = likely_turns(fresh, old);
    ASSERT_GE(turns_rad.size(), 2U) << turn_deg;
    EXPECT_EQ(turns_rad[0], 0) << "no turn is always tried";
    EXPECT_NEAR(to_degrees(turns_rad[1]), turn_deg, 0.5 + 1e-9);
  }
}

TEST(LikelyTurns, AreNoneWhereAxesHoldTheHeadingOrTheTurnIsTooLarge) {
  EXPECT_THAT(likely_turns(learned_walls(office(), {}, false), learned_walls(office(), {0, 0, 0.1}, true)),
              testing::ElementsAre(0));
  EXPECT_THAT(
      likely_turns(learned_walls(office(), {}, true), learned_walls(office(), {0, 0, 30 * kDegree}, true)),
      testing::ElementsAre(0));
}

RC_GTEST_PROP(RefineFit, LeavesAnExactFitAsItIs, ()) {
  const Pose2 T_map_track = any_turned_pose();
  const Submap submap = submap_of(office(), true);
  const WallPattern old(learned_walls(office(), T_map_track, true));
  const Pose2 exact = T_map_track * submap.T_track_anchor;
  RC_ASSERT(testing::Value(refine_fit(submap, exact, old, known_everywhere()).T_map_anchor,
                           PoseNear(exact, 1e-9, 1e-9)));
}

/// The guess of the heading has a deviation of 1 degree; that of the position is free.
TEST(RefineFit, WeighsTheGuessOfTheHeadingAgainstTheWalls) {
  const Submap submap = submap_of(office(), true);
  const WallPattern old(learned_walls(office(), {}, true));
  for (const double off_rad : {-1 * kDegree, -0.2 * kDegree, 0.2 * kDegree, 1 * kDegree}) {
    const Pose2 guess{submap.T_track_anchor.x + 0.03, submap.T_track_anchor.y - 0.02, off_rad};
    const RefinedFit fit = refine_fit(submap, guess, old, known_everywhere());
    const double by_walls = 1 / fit.information.inverse()(2, 2), by_guess = 1 / square(1 * kDegree);
    EXPECT_NEAR(fit.T_map_anchor.theta / off_rad, by_guess / (by_walls + by_guess), 0.005) << off_rad;
  }
}

/// How the distance of the submap's only wall from `old` changes with the anchor's x, y and heading.
Vec3 slopes_by_differences(const Submap& submap, const Pose2& T_map_anchor, const WallEstimate& old) {
  const auto off_m = [&](const Pose2& T) {
    Walls placed;
    place_walls(submap, T, placed);
    return old.offset_of(placed.front().middle());
  };
  constexpr double kStep = 1e-5;
  const auto slope = [&](const Pose2& d) {
    const Pose2& T = T_map_anchor;
    return (off_m({T.x + d.x, T.y + d.y, T.theta + d.theta}) -
            off_m({T.x - d.x, T.y - d.y, T.theta - d.theta})) /
           (2 * kStep);
  };
  return {slope({kStep, 0, 0}), slope({0, kStep, 0}), slope({0, 0, kStep})};
}

/// One wall gives information along its slopes alone, apart from what its heading says.
void expect_slopes(WallEstimate wall, const Interval& extent) {
  wall.extent = extent;
  Submap submap;
  submap.T_track_anchor = {3, 2, 0};
  submap.walls = {wall};
  const Pose2 exact = submap.T_track_anchor;
  const Mat3 information = refine_fit(submap, exact, WallPattern({wall}), known_everywhere()).information;
  const Vec3 slopes = slopes_by_differences(submap, exact, wall);
  const int axis = std::abs(slopes(0)) > std::abs(slopes(1)) ? 0 : 1;
  EXPECT_GT(information(axis, axis), 0);
  const Vec3 from_information = information.col(axis) / information(axis, axis) * slopes(axis);
  EXPECT_LT((from_information - slopes).norm(), 1e-6)
      << from_information.transpose() << " instead of " << slopes.transpose();
}

TEST(RefineFit, InformationFollowsTheSlopesOfTheDistances) {
  for (const Segment2& segment : office()) {
    const double half_m = segment.length() / 2;
    expect_slopes(learned_wall(segment, false), {-half_m, half_m});
    expect_slopes(learned_wall(segment, false), {-half_m, 3 * half_m});
    expect_slopes(learned_wall(Pose2{1, 2, 0.4} * segment, true), {-half_m, half_m});
    expect_slopes(learned_wall(Pose2{1, 2, 0.4} * segment, true), {-half_m, 3 * half_m});
  }
}

TEST(RefineFit, SaysNothingAlongACorridor) {
  for (const double direction_rad : {0.0, 0.3, -1.2}) {
    const Pose2 T_map_track{4, -2, direction_rad};
    const Submap submap = submap_of(bare_corridor(0, 6), true);
    const WallPattern old(learned_walls(bare_corridor(-20, 20), T_map_track, true));
    const Vec2 along = unit(direction_rad), across = left_normal(along);
    const Pose2 exact = T_map_track * submap.T_track_anchor;
    const Vec2 off = 0.4 * along + 0.05 * across;
    const Pose2 guess{exact.x + off.x(), exact.y + off.y(), exact.theta};
    const RefinedFit fit = refine_fit(submap, guess, old, known_everywhere());
    const Vec3 slide(along.x(), along.y(), 0);
    EXPECT_NEAR((fit.information * slide).norm(), 0, 1e-6);
    const Vec2 left = fit.T_map_anchor.position() - exact.position();
    EXPECT_NEAR(left.dot(across), 0, 1e-7);
    EXPECT_NEAR(left.dot(along), 0.4, 1e-7) << "the guess is kept";
  }
}

TEST(RefineFit, ErrsNoMoreThanItsInformationSays) {
  Random random(7);
  constexpr int kSubmaps = 400;
  const Submap submap = submap_of(office(), true);
  double squared = 0;
  for (int i = 0; i < kSubmaps; ++i) {
    Walls old = learned_walls(office(), {}, true);
    for (WallEstimate& wall : old) {
      wall.anchor += random.normal(0.03) * wall.normal;
      wall.set_heading(wrap_angle(wall.heading_rad + random.normal(1.5 * kDegree)));
    }
    const RefinedFit fit = refine_fit(submap, submap.T_track_anchor, WallPattern(old), known_everywhere());
    const Vec3 error(fit.T_map_anchor.x - submap.T_track_anchor.x,
                     fit.T_map_anchor.y - submap.T_track_anchor.y, fit.T_map_anchor.theta);
    squared += error.dot(fit.information * error);
  }
  EXPECT_LT(squared / kSubmaps, 3.0) << "three unknowns";
  EXPECT_GT(squared / kSubmaps, 1.0) << "nor much less";
}

}  // namespace
}  // namespace aisle
