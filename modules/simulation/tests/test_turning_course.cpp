#include "aisle/simulation/turning_course.hpp"

#include <gmock/gmock.h>

#include "aisle/simulation/free_floor.hpp"
#include "aisle/simulation/slice.hpp"

namespace aisle {
namespace {

TEST(TurningCourse, EachOfTheThirteenWaysIsFreeAndLeadsTheRightWay) {
  for (int number = 1; number <= 13; ++number) {
    Random random(7);
    const World world = turning_course(number, random);
    const std::vector<Vec2>& way = world.routes.front().way;
    EXPECT_GT(clearance_m(way, obstacles_below(world, 1)), 0.75) << number;
    EXPECT_EQ(world.turnings.front().number, number);
    EXPECT_EQ(world.start->position(), way.front());
  }
}

TEST(TurningCourse, ThereIsNoFourteenth) {
  Random random(1);
  EXPECT_THROW(turning_course(14, random), std::invalid_argument);
}

}  // namespace
}  // namespace aisle
