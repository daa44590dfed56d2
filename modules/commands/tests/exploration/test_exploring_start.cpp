#include <gmock/gmock.h>

#include "aisle/core/angle.hpp"
#include "aisle/simulation/obstacles.hpp"
#include "aisle/simulation/vehicle/simulated_vehicle.hpp"
#include "exploration/exploring_start.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

/// A hall of 12 m x 6 m along x.
World hall() {
  World world;
  const Vec2 corners[] = {{12, 0}, {12, 6}, {0, 6}, {0, 0}, {12, 0}};
  for (std::size_t i = 1; i < std::size(corners); ++i)
    world.walls.push_back({.floor_edge = {corners[i], corners[i - 1]}});
  return world;
}

TEST(ExploringStart, IsTheGivenPoseIfThereIsAPathAhead) {
  const Pose2 start{6, 3, 0.3};
  EXPECT_THAT(start_with_a_path(hall(), {}, start), PoseNear(start, 0, 0));
}

TEST(ExploringStart, BeforeACornerTheVehicleIsTurnedToAPath) {
  const Pose2 start{1.2, 1.2, -135 * kDegree};
  const Pose2 turned = start_with_a_path(hall(), {}, start);
  EXPECT_EQ(turned.position(), start.position());
  Obstacles obstacles(hall(), {});
  EXPECT_FALSE(obstacles.touch(turned));
  EXPECT_EQ(obstacles.free_share(turned, {.length_m = 2}), 1);
}

/// A closet of 1.4 m x 1.4 m in the left of a corridor.
World closet(std::vector<Vec2> tour) {
  World world;
  const Vec2 corners[] = {{1.4, 0}, {1.4, 1.4}, {0, 1.4}, {0, 0}, {10, 0}, {10, 1.4}, {1.4, 1.4}};
  for (std::size_t i = 1; i < std::size(corners); ++i)
    world.walls.push_back({.floor_edge = {corners[i], corners[i - 1]}});
  world.tour = std::move(tour);
  return world;
}

TEST(ExploringStart, WithoutAPathItIsPutFartherAlongTheTour) {
  const Pose2 moved = start_with_a_path(closet({{0.4, 0.7}, {1, 0.7}, {4, 0.7}}), {}, {0.4, 0.7, 0});
  EXPECT_THAT(moved, PoseNear(Pose2{4, 0.7, 0}, 1e-9, 1e-9));
}

TEST(ExploringStart, IsTheGivenPoseIfThereIsNoPathAnywhere) {
  const Pose2 start{0.4, 0.7, 0};
  EXPECT_THAT(start_with_a_path(closet({}), {}, start), PoseNear(start, 0, 0));
}

}  // namespace
}  // namespace aisle
