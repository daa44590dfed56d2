#include <gmock/gmock.h>

#include "aisle/simulation/plans/free_sides.hpp"

namespace aisle {
namespace {

TEST(FreeSides, TheFacesOfADoubleWallLookAwayFromEachOther) {
  const std::vector<Segment2> walls = {
      {{0, 0}, {4, 0}}, {{0, 0.2}, {4, 0.2}}, {{0, 3}, {4, 3}}, {{4, -3}, {0, -3}}};
  const auto turned = with_free_sides_left(walls);
  EXPECT_GT(turned[0].start.x(), turned[0].end.x()) << "the lower face looks down";
  EXPECT_LT(turned[1].start.x(), turned[1].end.x()) << "the upper face looks up";
}

TEST(FreeSides, AWallWithTheSameRoomOnBothSidesStays) {
  const std::vector<Segment2> walls = {{{0, 0}, {4, 0}}};
  EXPECT_EQ(with_free_sides_left(walls)[0].start, walls[0].start);
}

}  // namespace
}  // namespace aisle
