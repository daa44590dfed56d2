#include "aisle/localisation/pose_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "hand_building.hpp"

namespace aisle {
namespace {

std::vector<Vec2> every(const std::vector<Vec2>& hits, std::size_t step) {
  std::vector<Vec2> some;
  for (std::size_t i = 0; i < hits.size(); i += step) some.push_back(hits[i]);
  return some;
}

/// The scores of all poses of the grid, the best first.
std::vector<double> exhaustive(const LikelihoodPyramid& map, const PoseSearch& search) {
  std::vector<double> scores;
  for (int heading = 0; heading < PoseSearch::kHeadings; ++heading) {
    for (int y = 0; y < map.rows(); ++y) {
      for (int x = 0; x < map.columns(); ++x) scores.push_back(search.score(x, y, heading));
    }
  }
  std::sort(scores.rbegin(), scores.rend());
  return scores;
}

class ExhaustiveSearch : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Seeds, ExhaustiveSearch, testing::Range(1, 7));

TEST_P(ExhaustiveSearch, ReturnsWhatPoseSearchReturns) {
  Random random(static_cast<std::uint64_t>(GetParam()));
  Building building;
  for (int i = 0; i < 8; ++i) {
    const Vec2 p(random.uniform(0, 3), random.uniform(0, 2));
    building.walls.walls.push_back({.segment = {p, p + Vec2(random.uniform(-2, 2), random.uniform(-2, 2))}});
  }
  std::vector<Vec2> hits;
  for (int i = 0; i < 12; ++i) hits.emplace_back(random.uniform(-20, 20), random.uniform(-2, 2));
  for (int i = 0; i < 12; ++i) hits.emplace_back(random.uniform(-2, 2), random.uniform(-2, 2));
  const SurfaceField field(building);
  const LikelihoodPyramid map(field);
  PoseSearch search(map, hits, 0);
  const std::vector<double> scores = exhaustive(map, search);
  for (std::size_t i = 0; i < 200; ++i) {
    const auto pose = search.next(0, std::numeric_limits<std::size_t>::max());
    ASSERT_TRUE(pose);
    EXPECT_NEAR(pose->score, scores[i], 1e-6);
  }
}

TEST(PoseSearch, FindsWhereAScanWasTaken) {
  const Building building = hand::l_room();
  const SurfaceField field(building);
  const LikelihoodPyramid map(field);
  Random random(1);
  const Pose2 T_map_vehicle{7.3, 2.2, 130 * kDegree};
  PoseSearch search(map, every(hand::scan(building, T_map_vehicle, 20, random), 3), 0.5);
  const auto best = search.next(0.5, 10000000);
  ASSERT_TRUE(best);
  EXPECT_GT(best->score, 0.95);
  EXPECT_LT((best->T_map_vehicle.position() - T_map_vehicle.position()).norm(), 0.2);
  EXPECT_LT(std::abs(wrap_angle(best->T_map_vehicle.theta - T_map_vehicle.theta)), 3 * kDegree);
}

TEST(PoseSearch, ReturnsNothingBelowTheLeastScore) {
  const Building building = hand::bare_room();
  const SurfaceField field(building);
  const LikelihoodPyramid map(field);
  Random random(1);
  const std::vector<Vec2> hits = every(hand::scan(hand::l_room(), {2, 6, 1}, 20, random), 3);
  PoseSearch search(map, hits, 0.9);
  EXPECT_FALSE(search.next(0.9, 10000000));
  EXPECT_FALSE(search.is_cut_short());
}

}  // namespace
}  // namespace aisle
