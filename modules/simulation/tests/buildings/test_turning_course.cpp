#include "aisle/simulation/buildings/turning_course.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <utility>
#include <vector>

#include "aisle/simulation/cross_section.hpp"
#include "aisle/simulation/paths/free_floor.hpp"

namespace aisle {
namespace {

TEST(TurningCourse, EachOfTheThirteenRoutesIsFreeAndLeadsTheRightWay) {
  for (int number = 1; number <= 13; ++number) {
    Random random(7);
    const World world = turning_course(number, random);
    const std::vector<Vec2>& path = world.routes.front().path;
    EXPECT_GT(clearance_m(path, obstacles_below(world, 1)), 0.75) << number;
    EXPECT_EQ(world.turnings.front().number, number);
    EXPECT_EQ(world.start->position(), path.front());
  }
}

TEST(TurningCourse, CloseTurningsAreFreeAndBackBetweenThem) {
  for (const auto& [first, second] : {std::pair{6, 5}, std::pair{8, 7}}) {
    Random random(7);
    const World world = close_turnings_course(first, second, random);
    const std::vector<Vec2>& path = world.routes.front().path;
    EXPECT_GT(clearance_m(path, obstacles_below(world, 1)), 0.55) << first;
    ASSERT_EQ(world.turnings.size(), 2U);
    EXPECT_EQ(world.turnings[0].number, first);
    EXPECT_EQ(world.turnings[1].number, second);
    EXPECT_LT(std::abs(path[3].x()), std::abs(path[2].x())) << "between them it leads back";
  }
  Random random(7);
  EXPECT_THROW(close_turnings_course(1, 2, random), std::invalid_argument);
}

TEST(TurningCourse, ThereIsNoFourteenth) {
  Random random(1);
  EXPECT_THROW(turning_course(14, random), std::invalid_argument);
}

}  // namespace
}  // namespace aisle
