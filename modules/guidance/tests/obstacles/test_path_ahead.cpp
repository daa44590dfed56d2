#include <gmock/gmock.h>

#include "aisle/guidance/obstacles/path_ahead.hpp"

namespace aisle {
namespace {

const Footprint kCart{.front_m = 1, .rear_m = 0.2, .width_m = 0.6, .height_m = 1};

/// 2 m straight on, a quarter turn to the left with a radius of 1 m, 2 m straight on.
Path path_round_a_corner() {
  std::vector<PathPiece> pieces{{Pose2{}, {2, 0}}};
  pieces.push_back({pieces.back().end(), {kPi / 2, kPi / 2}});
  pieces.push_back({pieces.back().end(), {2, 0}});
  return Path(std::move(pieces));
}

std::optional<double> path_from_start(const Vec2& p, double reach_m) {
  const Path path = path_round_a_corner();
  return path_to(p, path_ahead(path, path.at(0), {}, reach_m), kCart, 0.1);
}

TEST(PathAhead, EndsAtAnObstacleOnIt) {
  EXPECT_NEAR(*path_from_start({2, 0.3}, 3), 1, 0.06);
  EXPECT_EQ(path_from_start({2, -0.45}, 1.5), std::nullopt);  // beside it
  EXPECT_EQ(path_from_start({2.9, 0}, 1.5), std::nullopt);    // farther than asked
  EXPECT_EQ(path_from_start({0.5, 0.35}, 3), std::nullopt);   // beside the vehicle already
}

TEST(PathAhead, GoesRoundCorners) {
  EXPECT_EQ(path_from_start({4.5, 0}, 4), std::nullopt);  // straight on, where it turns off
  const auto round = path_from_start({3, 2.3}, 4);
  ASSERT_TRUE(round);
  EXPECT_NEAR(*round, 2 + kPi / 2 + 1.3 - 1, 0.06);
}

TEST(PathAhead, StartsAtTheVehiclesActualPose) {
  const Path path = path_round_a_corner();
  const Pose2 T_map_vehicle{0.5, 0.1, 0};
  const PathAhead ahead = path_ahead(path, path.at(0.5), T_map_vehicle, 1);
  EXPECT_TRUE(path_to({1.2, -0.45}, ahead, kCart, 0.1));
  EXPECT_FALSE(path_to({1.2, 0.35}, ahead, kCart, 0.1));
}

TEST(PathAhead, EndsWhereTheVehicleStopsToGoBack) {
  std::vector<PathPiece> pieces{{Pose2{}, {0.5, 0}}};
  pieces.push_back({pieces.back().end(), {-2, 0}});
  const Path path(std::move(pieces));
  const PathAhead ahead = path_ahead(path, path.at(0), {}, 3);
  EXPECT_FALSE(path_to({1.7, 0}, ahead, kCart, 0.1));
  EXPECT_TRUE(path_to({1.4, 0}, ahead, kCart, 0.1));
}

}  // namespace
}  // namespace aisle
