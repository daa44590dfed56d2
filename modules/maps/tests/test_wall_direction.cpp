#include "aisle/maps/wall_direction.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace aisle {
namespace {

TEST(WallDirection, TheNearestWithinReachCounts) {
  const std::vector<WallDirection> known{{.p_map = {0, 0}, .direction_rad = 0.1},
                                         {.p_map = {4, 0}, .direction_rad = 0.2}};
  EXPECT_EQ(walls_around(known, {1.9, 0}, 2)->direction_rad, 0.1);
  EXPECT_EQ(walls_around(known, {2.1, 0}, 2)->direction_rad, 0.2);
  EXPECT_FALSE(walls_around(known, {4, 2.1}, 2));
  EXPECT_FALSE(walls_around({}, {0, 0}, 2));
}

}  // namespace
}  // namespace aisle
