#include <gtest/gtest.h>

#include <cmath>

#include "aisle/core/random.hpp"

namespace aisle {
namespace {

TEST(Random, TheSameSeedGivesTheSameNumbersForEver) {
  Random random(42);
  EXPECT_EQ(random.bits(), 15021278609987233951u);
  EXPECT_EQ(random.bits(), 5881210131331364753u);
}

TEST(Random, NormalHasItsMeanAndSigma) {
  Random random(1);
  double sum = 0, squares = 0;
  constexpr int kDraws = 20000;
  for (int i = 0; i < kDraws; ++i) {
    const double draw = random.normal(2);
    sum += draw;
    squares += draw * draw;
  }
  EXPECT_NEAR(sum / kDraws, 0, 0.06);
  EXPECT_NEAR(std::sqrt(squares / kDraws), 2, 0.06);
}

TEST(Random, EveryIndexIsDrawnAboutEquallyOften) {
  Random random(7);
  int counts[5] = {};
  for (int i = 0; i < 10000; ++i) ++counts[random.index(5)];
  for (int count : counts) EXPECT_NEAR(count, 2000, 200);
}

}  // namespace
}  // namespace aisle
