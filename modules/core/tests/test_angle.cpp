#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "aisle/core/angle.hpp"

namespace aisle {
namespace {

RC_GTEST_PROP(Angle, WrappingKeepsTheDirectionAndStaysInRange, (int turns, double part)) {
  RC_PRE(std::isfinite(part));
  const double angle = std::fmod(part, kPi);
  const double wrapped = wrap_angle(angle + 2 * kPi * (turns % 1000));
  RC_ASSERT(wrapped >= -kPi);
  RC_ASSERT(wrapped < kPi);
  RC_ASSERT(std::abs(std::cos(wrapped) - std::cos(angle)) < 1e-9);
  RC_ASSERT(std::abs(std::sin(wrapped) - std::sin(angle)) < 1e-9);
}

TEST(Angle, QuarterTurnsVanish) {
  EXPECT_NEAR(wrap_quarter_turn(kPi / 2 + 0.1), 0.1, 1e-12);
  EXPECT_NEAR(wrap_quarter_turn(-kPi - 0.2), -0.2, 1e-12);
  EXPECT_NEAR(wrap_quarter_turn(kPi / 4), -kPi / 4, 1e-12);
}

}  // namespace
}  // namespace aisle
