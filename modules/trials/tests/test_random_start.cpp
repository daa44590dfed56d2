#include "random_start.hpp"

#include <gmock/gmock.h>

#include "explorer_run.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;

constexpr double kAhead_m = 0.15;

/// The shipped cart, 1.20 m x 0.60 m, in a rectangle.
SimulationSetting cart_in(double length_m, double width_m) {
  SimulationSetting setting;
  setting.world_file = "rectangle.yaml";
  setting.world =
      walled_by({{0, 0}, {length_m, 0}, {length_m, width_m}, {0, width_m}}, {length_m / 2, width_m / 2, 0});
  setting.vehicle = cart_with_scanner();
  return setting;
}

TEST(RandomStart, LeavesSpaceOnAllSidesOfTheVehicle) {
  const SimulationSetting setting = cart_in(6, 4);
  Footprint needed = setting.vehicle.description.footprint;
  needed.front_m += kAhead_m;
  needed.rear_m += 0.15;
  needed.width_m += 0.3;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto T_world_start = random_start(setting, kAhead_m, seed);
    ASSERT_TRUE(T_world_start.ok()) << seed;
    EXPECT_TRUE(fits(setting.world, needed, *T_world_start)) << seed;
  }
}

TEST(RandomStart, IsTheSameForTheSameSeed) {
  const SimulationSetting setting = cart_in(6, 4);
  EXPECT_EQ(random_start(setting, kAhead_m, 7)->x, random_start(setting, kAhead_m, 7)->x);
  EXPECT_NE(random_start(setting, kAhead_m, 7)->x, random_start(setting, kAhead_m, 8)->x);
}

/// The vehicle fits at the world's start, but not with the space around it.
TEST(RandomStart, IsRefusedWhereTheVehicleHasNoSpace) {
  const auto T_world_start = random_start(cart_in(2.4, 0.8), kAhead_m, 1);
  ASSERT_FALSE(T_world_start.ok());
  EXPECT_THAT(to_string(T_world_start.problems()),
              HasSubstr("rectangle.yaml: walls: leave no space for a random start"));
  EXPECT_THAT(to_string(T_world_start.problems()),
              HasSubstr("1.20 x 0.60 m needs 0.15 m ahead and 0.15 m on its other sides"));
}

}  // namespace
}  // namespace aisle
