#include <gtest/gtest.h>

#include "aisle/maps/wall_map.hpp"

namespace aisle {
namespace {

Wall wall(const Vec2& start, const Vec2& end, bool is_orthogonal) {
  return {{start, end}, is_orthogonal};
}

TEST(WallMap, AnEmptyMapHasNoLengthAndNoShare) {
  EXPECT_EQ(WallMap{}.length_m(), 0);
  EXPECT_EQ(WallMap{}.orthogonal_share(), 0);
}

TEST(WallMap, LengthsAddUp) {
  const WallMap map{{wall({0, 0}, {3, 4}, false), wall({1, 1}, {1, -1}, true)}};
  EXPECT_DOUBLE_EQ(map.length_m(), 7);
}

TEST(WallMap, TheShareIsOfLengthNotOfWalls) {
  const WallMap map{
      {wall({0, 0}, {6, 0}, true), wall({0, 0}, {0, 3}, true), wall({0, 0}, {0.6, 0.8}, false)}};
  EXPECT_DOUBLE_EQ(map.orthogonal_share(), 0.9);
}

TEST(WallMap, WallsOfNoLengthHaveNoShare) {
  EXPECT_EQ((WallMap{{wall({1, 1}, {1, 1}, true)}}).orthogonal_share(), 0);
}

}  // namespace
}  // namespace aisle
