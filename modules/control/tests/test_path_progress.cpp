#include "aisle/control/path_progress.hpp"

#include <gtest/gtest.h>

#include "closed_loop.hpp"

namespace aisle {
namespace {

TEST(PathProgress, ComesBackOnlyAfterTheTurningPoint) {
  const Path path = path_of({{2, 0}, {-2, 0}});
  PathProgress progress(path);
  EXPECT_NEAR(progress.advance({1.0, 0.05, 0}).along_m, 1.0, 1e-12);
  EXPECT_NEAR(progress.advance({1.9, 0.05, 0}).along_m, 1.9, 1e-12);
  EXPECT_NEAR(progress.advance({2.0, 0.05, 0}).along_m, 2.0, 1e-12);
  EXPECT_EQ(progress.point().piece, 1);
  EXPECT_NEAR(progress.advance({1.5, 0.05, 0}).along_m, 2.5, 1e-12);
  EXPECT_FALSE(progress.has_arrived());
  progress.advance({0.8, 0, 0});
  progress.advance({0, 0, 0});
  EXPECT_TRUE(progress.has_arrived());
}

TEST(PathProgress, LeavesATurnOnTheSpotWhenItIsTurned) {
  const Path path = path_of({{1, 0}, {0, kPi / 2}, {1, 0}});
  PathProgress progress(path, 0.5);
  progress.advance({1, 0, 0});
  EXPECT_EQ(progress.point().piece, 1);
  progress.advance({1, 0, 80 * kDegree});
  EXPECT_EQ(progress.point().piece, 1);
  progress.advance({1, 0, 89.5 * kDegree});
  EXPECT_EQ(progress.point().piece, 2);
}

TEST(PathProgress, StaysInATurnOnTheSpotWhenThePathIsContinued) {
  const Path path = path_of({{1, 0}, {0, kPi / 2}});
  PathProgress progress(path);
  progress.advance({1, 0, 0});
  ASSERT_EQ(progress.advance({1, 0, 30 * kDegree}).piece, 1);
  const Path longer = path.followed_by(path_of({{1, 0}}, path.end()));
  PathProgress continued(longer, progress.point());
  EXPECT_EQ(continued.advance({1, 0, 40 * kDegree}).piece, 1);
  EXPECT_EQ(continued.advance({1, 0, 90 * kDegree}).piece, 2);
}

TEST(PathProgress, StaysOnItsPassWhereThePathCrossesItself) {
  const Path path = path_of({{3, 0}, {1.5 * kPi, 1.5 * kPi}, {3, 0}});
  PathProgress progress(path);
  for (double along_m = 0; along_m < path.length_m(); along_m += 0.05) {
    EXPECT_NEAR(progress.advance(path.at(along_m).T_map_path).along_m, along_m, 1e-9);
  }
}

/// A race track that is driven twice: the straight from the origin comes again after one lap.
TEST(PathProgress, IsFoundOnThePassThatItWasOnOrTheNextOne) {
  const double bend_m = 1.5 * kPi, round_m = 12 + 2 * bend_m;
  const Path path =
      path_of({{6, 0}, {bend_m, kPi}, {6, 0}, {bend_m, kPi}, {6, 0}, {bend_m, kPi}, {6, 0}, {bend_m, kPi}});
  PathProgress progress(path, 1);
  ASSERT_TRUE(progress.find({4, 0.2, 0.1}, 1));
  EXPECT_NEAR(progress.point().along_m, 4, 0.05);
  progress = PathProgress(path, round_m + 1);
  ASSERT_TRUE(progress.find({4, 0.2, 0.1}, 1));
  EXPECT_NEAR(progress.point().along_m, round_m + 4, 0.05);
  progress = PathProgress(path, 5);
  ASSERT_TRUE(progress.find({4, 2.9, kPi}, 1));
  EXPECT_NEAR(progress.point().along_m, 6 + bend_m + 2, 0.05);
}

TEST(PathProgress, IsNotFoundOffThePathOrFacingAnotherDirection) {
  const Path path = path_of({{6, 0}});
  PathProgress progress(path, 2);
  EXPECT_FALSE(progress.find({4, 0, kPi}, 1));
  EXPECT_FALSE(progress.find({4, 1.2, 0}, 1));
  EXPECT_EQ(progress.point().along_m, 2);
}

}  // namespace
}  // namespace aisle
