#include "aisle/geometry/box2.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace aisle {
namespace {

TEST(Box2, HoldsBothEndsOfEverySegment) {
  const Box2 box = box_around(std::vector<Segment2>{{{1, 4}, {3, -2}}, {{-5, 0}, {0, 1}}});
  EXPECT_EQ(box.min(), Vec2(-5, -2));
  EXPECT_EQ(box.max(), Vec2(3, 4));
}

TEST(Box2, HasNoSizeAroundASinglePoint) {
  const Box2 box = box_around(std::vector<Segment2>{{{2, 3}, {2, 3}}});
  EXPECT_FALSE(box.isEmpty());
  EXPECT_EQ(box.sizes(), Vec2::Zero());
}

TEST(Box2, IsEmptyWithoutSegments) {
  EXPECT_TRUE(box_around(std::vector<Segment2>()).isEmpty());
}

TEST(Box2, TakesTheSegmentsOfOtherThings) {
  struct Shelf {
    double height_m = 2;
    Segment2 front;
  };
  const Box2 box = box_around(std::vector<Shelf>{{.front = {{0, 1}, {2, 1}}}}, &Shelf::front);
  EXPECT_EQ(box.min(), Vec2(0, 1));
  EXPECT_EQ(box.max(), Vec2(2, 1));
}

}  // namespace
}  // namespace aisle
