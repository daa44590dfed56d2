#include "aisle/control/path.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <stdexcept>

#include "aisle/core/random.hpp"
#include "closed_loop.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

Path any_path(Random& random) {
  std::vector<Arc> arcs;
  const std::uint64_t count = 1 + random.index(6);
  for (std::uint64_t i = 0; i < count; ++i) {
    const bool is_line = random.uniform() < 0.4, on_the_spot = random.uniform() < 0.1;
    arcs.push_back({on_the_spot ? 0 : random.uniform(-3, 3), is_line ? 0 : random.uniform(-7, 7)});
  }
  return path_of(arcs, {random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-3, 3)});
}

TEST(Path, QuarterCircleByHand) {
  const Path path = path_of({{1, 0}, {kPi / 2, kPi / 2}});
  EXPECT_DOUBLE_EQ(path.length_m(), 1 + kPi / 2);
  EXPECT_THAT(path.at(0.5).T_map_path, PoseNear(Pose2{0.5, 0, 0}, 1e-12, 1e-12));
  EXPECT_THAT(path.at(9).T_map_path, PoseNear(Pose2{2, 1, kPi / 2}, 1e-12, 1e-12));
  const PathPoint inside = path.nearest({1 + 0.5 * std::sqrt(0.5), 1 - 0.5 * std::sqrt(0.5)}, 0, 9);
  EXPECT_NEAR(inside.along_m, 1 + kPi / 4, 1e-12);
  EXPECT_NEAR(inside.lateral_m, 0.5, 1e-12);
  EXPECT_NEAR(inside.curvature_per_m, 1, 1e-12);
}

TEST(Path, DrivenBackwardsItsDistanceStillGrows) {
  const Path path = path_of({{1, 0}, {-2, 0}});
  EXPECT_DOUBLE_EQ(path.length_m(), 3);
  EXPECT_THAT(path.at(2).T_map_path, PoseNear(Pose2{0, 0, 0}, 1e-12, 1e-12));
  EXPECT_NEAR(path.nearest({-0.5, 0.1}, 1, 3).along_m, 2.5, 1e-12);
  EXPECT_EQ(path.leg_end(0), 1);
  EXPECT_EQ(path.leg_end(1), 2);
  EXPECT_DOUBLE_EQ(path.leg_end_m(0), 1);
  EXPECT_DOUBLE_EQ(path.leg_end_m(1), 3);
}

TEST(Path, RejectsPiecesThatDoNotJoin) {
  EXPECT_THROW(Path({{{}, {1, 0}}, {{1.01, 0, 0}, {1, 0}}}), std::invalid_argument);
  EXPECT_THROW(Path({{{}, {1, 0}}, {{1, 0, 0.1}, {1, 0}}}), std::invalid_argument);
}

RC_GTEST_PROP(Path, NearestIsTheNearestOfManyPoints, (std::uint64_t seed)) {
  Random random(seed);
  const Path path = any_path(random);
  const Vec2 p =
      path.at(random.uniform(0, path.length_m())).T_map_path * Vec2{random.normal(), random.normal()};
  const double from_m = random.uniform(0, path.length_m());
  const double to_m = random.uniform(from_m, path.length_m());
  const PathPoint found = path.nearest(p, from_m, to_m);
  RC_ASSERT(found.along_m >= from_m - 1e-9 && found.along_m <= to_m + 1e-9);
  const double found_m = (found.T_map_path.position() - p).norm();
  for (int i = 0; i <= 300; ++i) {
    const double along_m = from_m + (to_m - from_m) * i / 300;
    RC_ASSERT((path.at(along_m).T_map_path.position() - p).norm() > found_m - 1e-9);
  }
}

RC_GTEST_PROP(Path, ItsFirstPartAndAnotherBehindItLieWhereTheyLay, (std::uint64_t seed)) {
  Random random(seed);
  const Path whole = any_path(random);
  const double cut_m = random.uniform(0.01, 1) * whole.length_m();
  RC_PRE(cut_m > 1e-3);
  const Path part = whole.up_to(cut_m);
  RC_ASSERT(std::abs(part.length_m() - cut_m) < 1e-9);
  const Path longer = part.followed_by(path_of({{1, 0.3}}, part.end()));
  RC_ASSERT(std::abs(longer.length_m() - cut_m - 1) < 1e-9);
  for (const double share : {0.0, 0.3, 0.7, 0.99}) {
    const Vec2 p = whole.at(share * cut_m).T_map_path.position();
    RC_ASSERT((longer.at(share * cut_m).T_map_path.position() - p).norm() < 1e-9);
  }
}

TEST(Path, ItsFirstPartKeepsATurnOnTheSpotThere) {
  const Path path = path_of({{2, 0}, {0, kPi / 2}, {1, 0}});
  EXPECT_NEAR(path.up_to(2).end().theta, kPi / 2, 1e-12);
  EXPECT_NEAR(path.up_to(2, 1).end().theta, 0, 1e-12) << "of the pieces before the turn";
  EXPECT_NEAR(path.up_to(1.5).end().x, 1.5, 1e-12);
}

TEST(Path, ItsEndIsAfterATurnOnTheSpotThere) {
  const Path path = path_of({{2, 0}, {0, kPi / 2}});
  EXPECT_NEAR(path.at(path.length_m()).T_map_path.theta, 0, 1e-12);
  EXPECT_NEAR(path.end().theta, kPi / 2, 1e-12);
  EXPECT_NEAR(path.end().x, 2, 1e-12);
}

RC_GTEST_PROP(Path, ReversedTwiceItIsItself, (std::uint64_t seed)) {
  Random random(seed);
  const Path path = any_path(random);
  const Path back = path.reversed(), again = back.reversed();
  const Pose2 about{0, 0, kPi};
  for (const double share : {0.0, 0.3, 0.5, 0.9, 1.0}) {
    const double along_m = share * path.length_m();
    const Vec2 p = path.at(along_m).T_map_path.position();
    RC_ASSERT((again.at(along_m).T_map_path.position() - p).norm() < 1e-9);
    RC_ASSERT((back.at(path.length_m() - along_m).T_map_path.position() - p).norm() < 1e-9);
  }
  const Pose2 end = path.end() * about;
  RC_ASSERT(std::abs(wrap_angle(back.pieces().front().T_map_start.theta - end.theta)) < 1e-9);
}

}  // namespace
}  // namespace aisle
