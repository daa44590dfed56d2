#include <gtest/gtest.h>

#include <cmath>

#include "aisle/simulation/paths/free_floor.hpp"

namespace aisle {
namespace {

std::vector<Segment2> box(const Vec2& low, const Vec2& high) {
  const Vec2 right(high.x(), low.y()), left(low.x(), high.y());
  return {{low, right}, {right, high}, {high, left}, {left, low}};
}

/// Two rooms of 4 m x 4 m with a door between them.
std::vector<Segment2> two_rooms(double door_m) {
  std::vector<Segment2> walls = box({0, 0}, {8, 4});
  walls.push_back({{4, 0}, {4, 2 - door_m / 2}});
  walls.push_back({{4, 2 + door_m / 2}, {4, 4}});
  return walls;
}

TEST(FreeFloor, AVehicleGetsThroughADoorThatIsWideEnough) {
  const std::vector<Segment2> walls = two_rooms(0.9);
  EXPECT_TRUE(FreeFloor(walls, {1, 1}, 0.3).reaches({7, 3}));
  EXPECT_FALSE(FreeFloor(walls, {1, 1}, 0.5).reaches({7, 3}));
}

TEST(FreeFloor, TheAreaIsWhereTheCentreMayBe) {
  EXPECT_NEAR(FreeFloor(box({0, 0}, {5, 3}), {1, 1}, 0.5).area_m2(), 4.0 * 2.0, 0.4);
  EXPECT_NEAR(FreeFloor(two_rooms(0.2), {1, 1}, 0.5).area_m2(), 3.0 * 3.0, 0.5);
}

TEST(FreeFloor, AFloorThatLeadsOutOfTheBuildingHasNoArea) {
  const std::vector<Segment2> three_walls = {{{0, 0}, {4, 0}}, {{4, 0}, {4, 4}}, {{4, 4}, {0, 4}}};
  EXPECT_TRUE(std::isinf(FreeFloor(three_walls, {1, 1}, 0.3).area_m2()));
}

TEST(FreeFloor, NothingIsReachedFromInsideAWall) {
  const FreeFloor floor(box({0, 0}, {4, 4}), {4, 2}, 0.3);
  EXPECT_EQ(floor.area_m2(), 0);
  EXPECT_FALSE(floor.reaches({2, 2}));
}

TEST(FreeFloor, ALargeBuildingIsSeenInLargerCells) {
  const FreeFloor floor(box({0, 0}, {5000, 5000}), {1000, 1000}, 0.3);
  EXPECT_TRUE(floor.reaches({4000, 4500}));
  EXPECT_NEAR(floor.area_m2(), 25e6, 1e5);
}

TEST(Clearance, IsTheLeastDistanceOfTheWholePath) {
  const std::vector<Segment2> walls = {{{0, 1}, {10, 1}}, {{5, -3}, {5, -0.4}}};
  const std::vector<Vec2> path = {{1, 0}, {9, 0}};
  EXPECT_NEAR(clearance_m(path, walls), 0.4, 1e-12);
  const std::vector<Vec2> through = {{4, -1}, {6, -1}};
  EXPECT_EQ(clearance_m(through, walls), 0);
  EXPECT_TRUE(std::isinf(clearance_m(path, {})));
}

}  // namespace
}  // namespace aisle
