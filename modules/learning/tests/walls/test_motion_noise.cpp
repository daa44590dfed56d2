#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "aisle/core/random.hpp"
#include "aisle/learning/walls/motion_noise.hpp"

namespace aisle {
namespace {

Vec3 variances(const Pose2& step) {
  return MotionNoise{}.covariance(step).diagonal();
}

RC_GTEST_PROP(MotionNoise, NeverFallsWithThePathOrTheTurn, (std::uint64_t seed)) {
  Random random(seed);
  const Pose2 step{random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-3, 3)};
  const double more = random.uniform(1, 3);
  const Pose2 farther{step.x * more, step.y * more, step.theta}, turned{step.x, step.y, step.theta * more};
  RC_ASSERT(((variances(farther) - variances(step)).array() >= 0).all());
  RC_ASSERT(((variances(turned) - variances(step)).array() >= 0).all());
}

RC_GTEST_PROP(MotionNoise, IsTheSameBackwardsAndToTheOtherSide, (std::uint64_t seed)) {
  Random random(seed);
  const Pose2 step{random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-3, 3)};
  RC_ASSERT(variances(step) == variances({-step.x, -step.y, -step.theta}));
}

TEST(MotionNoise, IsAlmostNothingForAVehicleThatStandsButNeverNothing) {
  const Vec3 standing = variances({});
  EXPECT_GT(standing.minCoeff(), 0);
  EXPECT_LT(standing.cwiseSqrt().maxCoeff(), 0.0011);
}

TEST(MotionNoise, AfterAMetreIsWhatTheParametersSay) {
  const Vec3 sigma = variances({1, 0, 0}).cwiseSqrt();
  EXPECT_NEAR(sigma.x(), 0.05, 0.001);
  EXPECT_NEAR(sigma.z(), 0.06, 0.001);
  EXPECT_LT(sigma.y(), sigma.x());
}

TEST(MotionNoise, HasNoCorrelations) {
  const Mat3 covariance = MotionNoise{}.covariance({1, 2, 3});
  EXPECT_TRUE(covariance.isDiagonal(0));
}

}  // namespace
}  // namespace aisle
