#include "studies/significance.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "aisle/core/random.hpp"

namespace aisle {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

TEST(Significance, WilsonAsPublished) {
  // Newcombe 1998, table I, method 3.
  const Confidence large = wilson_interval(81, 263);
  EXPECT_NEAR(large.low, 0.2553, 5e-5);
  EXPECT_NEAR(large.high, 0.3662, 5e-5);
  const Confidence none = wilson_interval(0, 20);
  EXPECT_EQ(none.low, 0);
  EXPECT_NEAR(none.high, 0.1611, 5e-5);
  EXPECT_EQ(wilson_interval(0, 0).high, 1);
}

TEST(Significance, McNemarByHand) {
  EXPECT_DOUBLE_EQ(mcnemar_p(0, 0), 1);
  EXPECT_NEAR(mcnemar_p(0, 5), 2 * std::pow(0.5, 5), 1e-12);
  EXPECT_NEAR(mcnemar_p(5, 1), 2 * 7 * std::pow(0.5, 6), 1e-12);
  EXPECT_DOUBLE_EQ(mcnemar_p(4, 4), 1);
}

TEST(Significance, SignFlipByHand) {
  EXPECT_DOUBLE_EQ(sign_flip_p({}), 1);
  EXPECT_DOUBLE_EQ(sign_flip_p({0, 0, 0}), 1);
  EXPECT_DOUBLE_EQ(sign_flip_p({1, 1, 1, 1}), 2.0 / 16);
  EXPECT_DOUBLE_EQ(sign_flip_p({3, 1, -1}), 6.0 / 8);  // sums 5, 3, 3 and 1 either way
}

TEST(Significance, NoiseIsSeldomTakenForADifference) {
  Random random(5);
  int taken = 0;
  for (int study = 0; study < 200; ++study) {
    std::vector<double> differences(12);
    for (double& difference : differences) difference = random.normal();
    taken += sign_flip_p(differences) < 0.05 ? 1 : 0;
  }
  EXPECT_LT(taken, 22);  // 10 expected, three standard deviations above
}

TEST(Significance, BootstrapHoldsTheMean) {
  const Confidence interval = bootstrap_interval({1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
  EXPECT_NEAR(interval.low, 5.5 - 1.96 * 2.872 / std::sqrt(10), 0.2);
  EXPECT_NEAR(interval.high, 5.5 + 1.96 * 2.872 / std::sqrt(10), 0.2);
  EXPECT_EQ(bootstrap_interval({7}).low, 7);
}

TEST(Significance, HolmByHand) {
  EXPECT_THAT(holm_adjusted({0.01, 0.04, 0.03}),
              ElementsAre(DoubleNear(0.03, 1e-12), DoubleNear(0.06, 1e-12), DoubleNear(0.06, 1e-12)));
  EXPECT_THAT(holm_adjusted({0.9, 0.8}), ElementsAre(1, 1));
}

}  // namespace
}  // namespace aisle
