#include "aisle/maps/room_route.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

namespace aisle {
namespace {

TEST(RoomRoute, ThirteenTurningsAreOfThreeClasses) {
  int left = 0, right = 0, straight = 0;
  for (int number = 1; number <= kTurningNumbers; ++number) {
    const TurningClass kind = class_of_turning(number);
    left += kind == TurningClass::kLeft ? 1 : 0;
    right += kind == TurningClass::kRight ? 1 : 0;
    straight += kind == TurningClass::kStraightOn ? 1 : 0;
  }
  EXPECT_EQ(left, 5);
  EXPECT_EQ(right, 5);
  EXPECT_EQ(straight, 3);
  EXPECT_THROW(class_of_turning(0), std::invalid_argument);
  EXPECT_THROW(class_of_turning(14), std::invalid_argument);
}

TEST(RoomRoute, ATurnMasksHalfOfTheOtherSideAndThenAQuarter) {
  const RoomTurning left{.number = 1, .start_m = 2, .end_m = 6},
      right{.number = 12, .start_m = 2, .end_m = 6};
  EXPECT_EQ(mask_out(left, 4.9), (MaskOut{.right = 0.5}));
  EXPECT_EQ(mask_out(left, 5.1), (MaskOut{.right = 0.25}));
  EXPECT_EQ(mask_out(right, 4.9), (MaskOut{.left = 0.5}));
  EXPECT_EQ(mask_out(right, 5.1), (MaskOut{.left = 0.25}));
}

TEST(RoomRoute, StraightOnMasksTheSidesOfTheBranches) {
  EXPECT_EQ(mask_out({.number = 2, .end_m = 1}, 0), (MaskOut{.left = 0.25}));
  EXPECT_EQ(mask_out({.number = 4, .end_m = 1}, 0), (MaskOut{.right = 0.25}));
  EXPECT_EQ(mask_out({.number = 9, .end_m = 1}, 0), (MaskOut{.left = 0.25, .right = 0.25}));
}

TEST(RoomRoute, OfTurningsThatOverlapTheLaterOneCounts) {
  const std::vector<RoomTurning> turnings = {{1, 1, 4}, {3, 3, 5}};
  EXPECT_EQ(turning_at(turnings, 0.9), nullptr);
  EXPECT_EQ(turning_at(turnings, 2)->number, 1);
  EXPECT_EQ(turning_at(turnings, 3.5)->number, 3);
  EXPECT_EQ(turning_at(turnings, 5), nullptr);
}

}  // namespace
}  // namespace aisle
