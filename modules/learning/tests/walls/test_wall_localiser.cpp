#include <gmock/gmock.h>

#include "aisle/core/square.hpp"
#include "aisle/learning/walls/wall_localiser.hpp"
#include "cast_scans.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

/// A room of 8 x 5 m with a cupboard in one corner.
WallMap room() {
  WallMap map;
  const Vec2 corners[] = {{0, 0}, {8, 0}, {8, 5}, {1.5, 5}, {1.5, 4}, {0, 4}};
  for (std::size_t i = 0; i < std::size(corners); ++i)
    map.walls.push_back({.segment = {corners[i], corners[(i + 1) % std::size(corners)]},
                         .is_orthogonal = true,
                         .sightings = 9,
                         .sigma_m = 0.01});
  return map;
}

/// What a scanner in the middle of the vehicle measures.
std::vector<float> scan_from(const Pose2& T_map_vehicle) {
  std::vector<Segment2> walls;
  for (const Wall& wall : room().walls) walls.push_back(wall.segment);
  return cast_scan(walls, T_map_vehicle, kOneReadingADegree, 181);
}

UncertainPose2 about_there(const Pose2& T) {
  return {T, Vec3(square(0.1), square(0.1), square(0.05)).asDiagonal()};
}

TEST(WallLocaliser, FindsItsPoseFromARoughGuess) {
  const Pose2 truth{4, 2, 0.3};
  WallLocaliser localiser({}, kOneReadingADegree, room(), about_there(truth * Pose2{0.1, -0.08, 0.04}));
  for (int i = 0; i < 5; ++i) localiser.take_scan(scan_from(truth), {});
  EXPECT_THAT(localiser.T_map_vehicle().mean, PoseNear(truth, 0.01, 0.005));
  EXPECT_FALSE(localiser.is_doubtful());
}

TEST(WallLocaliser, KeepsItsPoseThoughTheOdometryIsWrong) {
  Pose2 truth{1.5, 2, 0};
  WallLocaliser localiser({}, kOneReadingADegree, room(), about_there(truth));
  for (int i = 0; i < 60; ++i) {
    const Pose2 step{0.05, 0, 0.01};
    truth = truth * step;
    localiser.take_scan(scan_from(truth), {1.1 * step.x, 0.002, step.theta + 0.003});
  }
  EXPECT_THAT(localiser.T_map_vehicle().mean, PoseNear(truth, 0.02, 0.01));
}

TEST(WallLocaliser, IsDoubtfulWhenItSeesOtherWallsThanItKnows) {
  WallMap elsewhere = room();
  for (Wall& wall : elsewhere.walls) wall.segment = Pose2{0.9, 1.3, 0.5} * wall.segment;
  WallLocaliser localiser({}, kOneReadingADegree, elsewhere, about_there({4, 2, 0}));
  localiser.take_scan(scan_from({4, 2, 0}), {});
  EXPECT_TRUE(localiser.is_doubtful());
}

}  // namespace
}  // namespace aisle
