#include "aisle/vehicle/gear.hpp"

#include <gtest/gtest.h>

namespace aisle {
namespace {

TEST(Gear, SignedLengthsKeepTheirGear) {
  for (const Gear gear : {Gear::kForward, Gear::kReverse}) {
    EXPECT_EQ(gear_of(0.3 * sign(gear)), gear);
    EXPECT_EQ(sign(opposite(gear)), -sign(gear));
  }
  EXPECT_EQ(gear_of(0), Gear::kForward);
}

}  // namespace
}  // namespace aisle
